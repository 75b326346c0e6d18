// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/kernel/blas.h>
#include <setsudan/solver/linear/cholesky_factor.h>
#include <setsudan/solver/linear/elimination_order.h>
#include <setsudan/solver/linear/linear_solver.h>

#include <Teuchos_BLAS.hpp>

#include <algorithm>
#include <numeric>

namespace Setsudan
{
/** CHOLMOD's objects, which are its own to free. */
struct CholeskyFactor::Workspace
{
  Workspace()
  {
    cholmod_start(&common);
    common.print = 0;
  }

  ~Workspace()
  {
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }

  cholmod_common common;
  cholmod_factor *factor = nullptr;
};



namespace
{
std::vector<unsigned int>
all_unknowns(const LA::SparseMatrix &matrix)
{
  std::vector<unsigned int> unknowns(matrix.m());
  std::iota(unknowns.begin(), unknowns.end(), 0);
  return unknowns;
}
} // namespace


CholeskyFactor::CholeskyFactor(const LA::SparseMatrix &matrix)
  : CholeskyFactor(matrix, all_unknowns(matrix), {}, 0.)
{
}



CholeskyFactor::CholeskyFactor(const LA::SparseMatrix &matrix,
                               const std::vector<unsigned int> &first,
                               const std::vector<unsigned int> &last,
                               const double shift)
  : workspace(std::make_unique<Workspace>())
  , n_at_end(last.size())
  , place(matrix.m(), -1)
{
  auto &common = workspace->common;
  order        = order_of_elimination(matrix, first, common);
  order.insert(order.end(), last.begin(), last.end());
  for (unsigned int i = 0; i < order.size(); ++i)
    place[order[i]] = i;

  cholmod_sparse *const lower = in_order(matrix, shift);
  // The order is as it should be already, and the last must remain last.
  common.nmethods           = 1;
  common.method[0].ordering = CHOLMOD_NATURAL;
  common.postorder          = false;
  common.supernodal         = CHOLMOD_SUPERNODAL;
  workspace->factor         = cholmod_analyze(lower, &common);
  factorize(lower);
}



cholmod_sparse *
CholeskyFactor::in_order(const LA::SparseMatrix &matrix,
                         const double shift) const
{
  cholmod_sparse *const lower =
    lower_triangle(matrix, place, order.size(), workspace->common);
  const auto *const columns = static_cast<const int *>(lower->p);
  const auto *const rows    = static_cast<const int *>(lower->i);
  auto *const values        = static_cast<double *>(lower->x);
  for (unsigned int i = order.size() - n_at_end; i < order.size(); ++i)
    for (int e = columns[i]; e < columns[i + 1]; ++e)
      if (rows[e] == static_cast<int>(i))
        values[e] += shift;
  return lower;
}



void
CholeskyFactor::factorize(cholmod_sparse *lower)
{
  auto &common    = workspace->common;
  const bool done = workspace->factor != nullptr &&
                    cholmod_factorize(lower, workspace->factor, &common);
  const bool positive = common.status != CHOLMOD_NOT_POSDEF;
  cholmod_free_sparse(&lower, &common);
  if (!positive)
    throw NotDefiniteError(
      "The direct solver's factorization failed: the matrix is singular to "
      "working precision. Check that supports hold the body.");
  if (!done)
    throw SolverError(
      "The direct solver's factorization failed: memory ran out.");
}



void
CholeskyFactor::update(const LA::SparseMatrix &matrix, const double shift)
{
  Assert(matrix.m() == place.size(), dealii::ExcInternalError());
  factorize(in_order(matrix, shift));
}



CholeskyFactor::~CholeskyFactor() = default;


double
CholeskyFactor::n_entries() const
{
  return workspace->factor->xsize;
}



std::vector<double>
CholeskyFactor::in_order(const LA::Vector &vector) const
{
  const double *const values = vector.trilinos_vector()[0];
  std::vector<double> ordered(order.size());
  for (unsigned int i = 0; i < order.size(); ++i)
    ordered[i] = values[order[i]];
  return ordered;
}



void
CholeskyFactor::from_order(const std::vector<double> &ordered,
                           LA::Vector &vector) const
{
  double *const values = vector.trilinos_vector()[0];
  for (unsigned int i = 0; i < order.size(); ++i)
    values[order[i]] = ordered[i];
}



namespace
{
/** Columns of a factor that have entries in the same rows. */
struct Supernode
{
  Supernode(const cholmod_factor &factor, const unsigned int number)
  {
    const auto column    = static_cast<const int *>(factor.super) + number;
    const auto row_start = static_cast<const int *>(factor.pi) + number;
    first                = column[0];
    n_columns            = column[1] - column[0];
    n_rows               = row_start[1] - row_start[0];
    rows                 = static_cast<const int *>(factor.s) + row_start[0];
    values               = static_cast<const double *>(factor.x) +
             static_cast<const int *>(factor.px)[number];
  }

  int first, n_columns, n_rows;
  /** In ascending order, from the diagonal on. */
  const int *rows;
  /** By columns of length n_rows. */
  const double *values;
};



/** One step of solving L y = b or L^T x = y.
 *
 * @param n_columns from the first one of the supernode on.
 * @param below     room for what lies below. */
void
solve_lower(const Supernode &node,
            const int n_columns,
            std::vector<double> &x,
            std::vector<double> &below)
{
  const int n_below = node.n_rows - n_columns;
  solve_triangle(node.values, n_columns, node.n_rows, false, &x[node.first]);
  Teuchos::BLAS<int, double>().GEMV(Teuchos::NO_TRANS,
                                    n_below,
                                    n_columns,
                                    1.,
                                    node.values + n_columns,
                                    node.n_rows,
                                    &x[node.first],
                                    1,
                                    0.,
                                    below.data(),
                                    1);
  for (int i = 0; i < n_below; ++i)
    x[node.rows[n_columns + i]] -= below[i];
}



void
solve_upper(const Supernode &node,
            const int n_columns,
            std::vector<double> &x,
            std::vector<double> &below)
{
  const int n_below = node.n_rows - n_columns;
  for (int i = 0; i < n_below; ++i)
    below[i] = x[node.rows[n_columns + i]];
  Teuchos::BLAS<int, double>().GEMV(Teuchos::TRANS,
                                    n_below,
                                    n_columns,
                                    -1.,
                                    node.values + n_columns,
                                    node.n_rows,
                                    below.data(),
                                    1,
                                    1.,
                                    &x[node.first],
                                    1);
  solve_triangle(node.values, n_columns, node.n_rows, true, &x[node.first]);
}
} // namespace


void
CholeskyFactor::forward_eliminate(std::vector<double> &x) const
{
  const cholmod_factor &factor = *workspace->factor;
  const int end                = order.size() - n_at_end;
  std::vector<double> below(order.size());
  for (unsigned int s = 0; s < factor.nsuper; ++s)
    {
      const Supernode node(factor, s);
      if (node.first < end)
        solve_lower(node, std::min(node.n_columns, end - node.first), x, below);
    }
}



void
CholeskyFactor::back_substitute(std::vector<double> &x) const
{
  const cholmod_factor &factor = *workspace->factor;
  const int end                = order.size() - n_at_end;
  std::vector<double> below(order.size());
  for (unsigned int s = factor.nsuper; s-- > 0;)
    {
      const Supernode node(factor, s);
      if (node.first < end)
        solve_upper(node, std::min(node.n_columns, end - node.first), x, below);
    }
}



std::vector<double>
CholeskyFactor::last_block() const
{
  const cholmod_factor &factor = *workspace->factor;
  const int end                = order.size() - n_at_end;
  std::vector<double> block(std::size_t(n_at_end) * n_at_end, 0.);
  for (unsigned int s = 0; s < factor.nsuper; ++s)
    {
      const Supernode node(factor, s);
      for (int c = std::max(0, end - node.first); c < node.n_columns; ++c)
        for (int r = c; r < node.n_rows; ++r)
          block[std::size_t(node.first + c - end) * n_at_end + node.rows[r] -
                end] = node.values[std::size_t(c) * node.n_rows + r];
    }
  return block;
}
} // namespace Setsudan
