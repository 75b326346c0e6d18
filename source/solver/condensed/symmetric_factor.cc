// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/parameters/exceptions.h>
#include <setsudan/solver/condensed/symmetric_factor.h>

/** LAPACK's factors of symmetric matrices, which have no wrapper. */
extern "C"
{
  void
  dsytrf_(const char *uplo,
          const int *n,
          double *a,
          const int *lda,
          int *ipiv,
          double *work,
          const int *lwork,
          int *info);
  void
  dsytrs2_(const char *uplo,
           const int *n,
           const int *nrhs,
           double *a,
           const int *lda,
           const int *ipiv,
           double *b,
           const int *ldb,
           double *work,
           int *info);
}

namespace Setsudan
{
using namespace dealii;

SymmetricFactor::SymmetricFactor(LAPACKFullMatrix<double> &&matrix)
  : factor(std::move(matrix))
  , pivots(factor.m())
{
  const int n = factor.m();
  if (n == 0)
    return;
  int info = 0, size = -1;
  double best_size = 0;
  dsytrf_("L", &n, &factor(0, 0), &n, pivots.data(), &best_size, &size, &info);
  size = static_cast<int>(best_size);
  std::vector<double> workspace(size);
  dsytrf_(
    "L", &n, &factor(0, 0), &n, pivots.data(), workspace.data(), &size, &info);
  if (info != 0)
    throw SolverError(
      "The stiffness of the unknowns that touch is singular. Check that "
      "supports hold the body.");
}



unsigned int
SymmetricFactor::n_negative() const
{
  unsigned int n = 0;
  for (unsigned int i = 0; i < pivots.size(); ++i)
    if (pivots[i] < 0)
      {
        // Two rows at once, where neither alone is large enough: of these
        // eigenvalues one is negative.
        ++n;
        ++i;
      }
    else if (factor(i, i) < 0)
      ++n;
  return n;
}



void
SymmetricFactor::solve(double *columns, const unsigned int n_columns) const
{
  const int n = factor.m(), n_rhs = n_columns;
  if (n == 0 || n_rhs == 0)
    return;
  int info = 0;
  std::vector<double> workspace(n);
  dsytrs2_("L",
           &n,
           &n_rhs,
           &factor(0, 0),
           &n,
           pivots.data(),
           columns,
           &n,
           workspace.data(),
           &info);
  AssertThrow(info == 0, ExcInternalError());
}



void
SymmetricFactor::solve(LAPACKFullMatrix<double> &columns) const
{
  AssertDimension(columns.m(), factor.m());
  if (columns.m() > 0 && columns.n() > 0)
    solve(&columns(0, 0), columns.n());
}



void
SymmetricFactor::solve(std::vector<double> &column) const
{
  AssertDimension(column.size(), factor.m());
  solve(column.data(), 1);
}
} // namespace Setsudan
