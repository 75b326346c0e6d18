// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/linear/elimination_order.h>
#include <setsudan/solver/linear/linear_solver.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <mutex>
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
} // namespace


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
              if (other >= place[row])
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



std::vector<int>
order_of_elimination(const LA::SparseMatrix &matrix,
                     const std::vector<unsigned int> &unknowns,
                     cholmod_common &common)
{
  std::vector<int> place(matrix.m(), -1);
  for (unsigned int i = 0; i < unknowns.size(); ++i)
    place[unknowns[i]] = i;
  std::vector<int> order(unknowns.size());
  if (!unknowns.empty())
    {
      cholmod_sparse *graph =
        lower_triangle(matrix, place, unknowns.size(), common);
      // METIS draws from C's random numbers, which threads share: one at a time
      // finds the same order in every run.
      static std::mutex one_at_a_time;
      const std::lock_guard<std::mutex> lock(one_at_a_time);
      const bool found =
        cholmod_metis(graph, nullptr, 0, true, order.data(), &common);
      cholmod_free_sparse(&graph, &common);
      if (!found)
        throw SolverError("METIS found no order of elimination.");
    }
  for (int &unknown : order)
    unknown = unknowns[unknown];
  return order;
}
} // namespace Setsudan
