// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <setsudan/kernel/blas.h>
#include <setsudan/solver/condensed/incremental_cholesky.h>
#include <setsudan/solver/linear/linear_solver.h>

#include <Teuchos_BLAS.hpp>
#include <Teuchos_LAPACK.hpp>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

IncrementalCholesky::IncrementalCholesky(const unsigned int most)
  : most(most)
{
  factor.resize_fast(std::size_t(most) * most);
}



unsigned int
IncrementalCholesky::size() const
{
  return n;
}



void
IncrementalCholesky::append(
  const unsigned int n_new,
  const std::function<double(unsigned int, unsigned int)> &entry_of)
{
  if (n_new == 0)
    return;
  AssertIndexRange(n + n_new, most + 1);
  const auto entry = [&](const unsigned int row, const unsigned int column) {
    return factor.data() + std::size_t(column) * most + row;
  };
  for (unsigned int column = 0; column < n + n_new; ++column)
    for (unsigned int row = std::max(n, column); row < n + n_new; ++row)
      *entry(row, column) = entry_of(row, column);

  const Teuchos::BLAS<int, double> blas;
  const Teuchos::LAPACK<int, double> lapack;
  if (n > 0)
    {
      blas.TRSM(Teuchos::RIGHT_SIDE,
                Teuchos::LOWER_TRI,
                Teuchos::TRANS,
                Teuchos::NON_UNIT_DIAG,
                n_new,
                n,
                1.,
                factor.data(),
                most,
                entry(n, 0),
                most);
      blas.SYRK(Teuchos::LOWER_TRI,
                Teuchos::NO_TRANS,
                n_new,
                n,
                -1.,
                entry(n, 0),
                most,
                1.,
                entry(n, n),
                most);
    }
  int info = 0;
  lapack.POTRF('L', n_new, entry(n, n), most, &info);
  if (info != 0)
    throw SolverError(
      "The cut's equations are singular to working precision. Check that "
      "supports hold the body, or set Division/Solve = every row anew.");
  n += n_new;
}



void
IncrementalCholesky::shrink(const unsigned int n_left)
{
  AssertIndexRange(n_left, n + 1);
  n = n_left;
}



void
IncrementalCholesky::solve(std::vector<double> &x) const
{
  const int n_solved = x.size();
  AssertIndexRange(x.size(), n + 1);
  if (n_solved == 0)
    return;
  // LAPACK's solve is for many right-hand sides, and slow for one.
  for (const bool transposed : {false, true})
    solve_triangle(factor.data(), n_solved, most, transposed, x.data());
}



void
IncrementalCholesky::solve_lower(LAPACKFullMatrix<double> &b) const
{
  AssertDimension(b.m(), n);
  if (b.n_elements() == 0)
    return;
  const Teuchos::BLAS<int, double> blas;
  blas.TRSM(Teuchos::LEFT_SIDE,
            Teuchos::LOWER_TRI,
            Teuchos::NO_TRANS,
            Teuchos::NON_UNIT_DIAG,
            b.m(),
            b.n(),
            1.,
            factor.data(),
            most,
            &b(0, 0),
            b.m());
}
} // namespace Setsudan
