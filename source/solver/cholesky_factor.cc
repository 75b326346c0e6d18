#include <setsudan/solver/cholesky_factor.h>
#include <setsudan/solver/linear_solver.h>

#include <Epetra_CrsMatrix.h>
#include <cholmod.h>

#include <algorithm>
#include <numeric>

namespace Setsudan
{
namespace
{
/** The rows of a matrix that one process has. */
struct RowView
{
  int n_entries;
  double *values;
  int *columns;

  RowView(const LA::SparseMatrix &matrix, const int row)
  {
    matrix.trilinos_matrix().ExtractMyRowView(row, n_entries, values, columns);
  }
};


/**
 * The lower triangle of a matrix in another order, in CHOLMOD's format.
 *
 * @param place where each unknown comes; those that are not wanted come
 *   nowhere, at -1.
 */
cholmod_sparse *
lower_triangle(const LA::SparseMatrix &matrix,
               const std::vector<int> &place,
               const unsigned int n,
               cholmod_common &common)
{
  const auto for_each_entry = [&](const auto &visit) {
    for (unsigned int row = 0; row < place.size(); ++row)
      if (place[row] >= 0)
        {
          const RowView view(matrix, row);
          for (int e = 0; e < view.n_entries; ++e)
            {
              const int other = place[view.columns[e]];
              // The matrix is symmetric: each entry below is met once.
              if (other >= place[row] && view.values[e] != 0)
                visit(place[row], other, view.values[e]);
            }
        }
  };
  std::vector<int> starts(n + 1, 0);
  for_each_entry([&](const int column, int, double) { ++starts[column + 1]; });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());

  cholmod_sparse *lower = cholmod_allocate_sparse(
    n, n, starts[n], false, true, -1, CHOLMOD_REAL, &common);
  if (lower == nullptr)
    throw SolverError("There is no memory for the matrix's factorization.");
  auto *const columns = static_cast<int *>(lower->p);
  auto *const rows    = static_cast<int *>(lower->i);
  auto *const values  = static_cast<double *>(lower->x);
  std::copy(starts.begin(), starts.end(), columns);
  for_each_entry([&](const int column, const int row, const double value) {
    rows[starts[column]]   = row;
    values[starts[column]] = value;
    ++starts[column];
  });
  return lower;
}
} // namespace


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
    cholmod_free_dense(&result, &common);
    cholmod_free_dense(&scratch, &common);
    cholmod_free_dense(&scratch_2, &common);
    cholmod_finish(&common);
  }

  std::vector<double>
  solve(const int system, const std::vector<double> &b)
  {
    cholmod_dense right{};
    right.nrow  = b.size();
    right.ncol  = 1;
    right.nzmax = b.size();
    right.d     = b.size();
    right.x     = const_cast<double *>(b.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    if (!cholmod_solve2(system,
                        factor,
                        &right,
                        nullptr,
                        &result,
                        nullptr,
                        &scratch,
                        &scratch_2,
                        &common))
      throw SolverError("The direct solver's solve failed: memory ran out.");
    const auto *const x = static_cast<const double *>(result->x);
    return {x, x + b.size()};
  }

  cholmod_common common;
  cholmod_factor *factor   = nullptr;
  cholmod_dense *result    = nullptr;
  cholmod_dense *scratch   = nullptr;
  cholmod_dense *scratch_2 = nullptr;
};



namespace
{
/** The unknowns in the order of elimination. */
std::vector<int>
order_of_elimination(const LA::SparseMatrix &matrix,
                     const std::vector<unsigned int> &last,
                     cholmod_common &common)
{
  std::vector<int> place(matrix.m(), 0);
  for (const unsigned int unknown : last)
    place[unknown] = -1;
  std::vector<int> interior;
  for (unsigned int unknown = 0; unknown < place.size(); ++unknown)
    if (place[unknown] == 0)
      {
        place[unknown] = interior.size();
        interior.push_back(unknown);
      }
  std::vector<int> order(interior.size());
  if (!interior.empty())
    {
      cholmod_sparse *graph =
        lower_triangle(matrix, place, interior.size(), common);
      const bool found =
        cholmod_metis(graph, nullptr, 0, true, order.data(), &common);
      cholmod_free_sparse(&graph, &common);
      if (!found)
        throw SolverError("METIS found no order of elimination.");
    }
  for (int &unknown : order)
    unknown = interior[unknown];
  order.insert(order.end(), last.begin(), last.end());
  return order;
}
} // namespace


CholeskyFactor::CholeskyFactor(const LA::SparseMatrix &matrix,
                               const std::vector<unsigned int> &last,
                               const double shift)
  : workspace(std::make_unique<Workspace>())
  , n_at_end(last.size())
{
  auto &common = workspace->common;
  order        = order_of_elimination(matrix, last, common);
  std::vector<int> place(order.size());
  for (unsigned int i = 0; i < order.size(); ++i)
    place[order[i]] = i;

  cholmod_sparse *lower = lower_triangle(matrix, place, order.size(), common);
  auto *const columns   = static_cast<int *>(lower->p);
  auto *const rows      = static_cast<int *>(lower->i);
  auto *const values    = static_cast<double *>(lower->x);
  for (unsigned int i = order.size() - n_at_end; i < order.size(); ++i)
    for (int e = columns[i]; e < columns[i + 1]; ++e)
      if (rows[e] == static_cast<int>(i))
        values[e] += shift;

  // The order is as it should be already, and the last must remain last.
  common.nmethods           = 1;
  common.method[0].ordering = CHOLMOD_NATURAL;
  common.postorder          = false;
  common.supernodal         = CHOLMOD_SUPERNODAL;
  workspace->factor         = cholmod_analyze(lower, &common);
  const bool done           = workspace->factor != nullptr &&
                    cholmod_factorize(lower, workspace->factor, &common);
  const bool positive = common.status != CHOLMOD_NOT_POSDEF;
  cholmod_free_sparse(&lower, &common);
  if (!done || !positive)
    throw SolverError(
      positive
        ? "The direct solver's factorization failed: memory ran out."
        : "The direct solver's factorization failed: the matrix is singular to "
          "working precision. Check that supports hold the body.");
}



CholeskyFactor::~CholeskyFactor() = default;


unsigned int
CholeskyFactor::n_last() const
{
  return n_at_end;
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



std::vector<double>
CholeskyFactor::solve_lower(const std::vector<double> &b) const
{
  return workspace->solve(CHOLMOD_L, b);
}



std::vector<double>
CholeskyFactor::solve_upper(const std::vector<double> &y) const
{
  return workspace->solve(CHOLMOD_Lt, y);
}



std::vector<double>
CholeskyFactor::last_block() const
{
  const cholmod_factor &factor = *workspace->factor;
  const auto *const supers     = static_cast<const int *>(factor.super);
  const auto *const row_starts = static_cast<const int *>(factor.pi);
  const auto *const starts     = static_cast<const int *>(factor.px);
  const auto *const rows       = static_cast<const int *>(factor.s);
  const auto *const values     = static_cast<const double *>(factor.x);
  const int first              = order.size() - n_at_end;
  std::vector<double> block(std::size_t(n_at_end) * n_at_end, 0.);
  for (unsigned int s = 0; s < factor.nsuper; ++s)
    {
      const int n_rows = row_starts[s + 1] - row_starts[s];
      for (int column = std::max(supers[s], first); column < supers[s + 1];
           ++column)
        for (int r = column - supers[s]; r < n_rows; ++r)
          block[std::size_t(column - first) * n_at_end +
                rows[row_starts[s] + r] - first] =
            values[starts[s] + std::size_t(column - supers[s]) * n_rows + r];
    }
  return block;
}
} // namespace Setsudan
