// SPDX-License-Identifier: LGPL-2.1-or-later
// The direct solver over several processes tells how many eigenvalues of a
// matrix are negative, and what it takes for positive definite it refuses where
// it is not.

#include <setsudan/solver/linear/mumps_solver.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../test_setup.h"

using namespace dealii;
using namespace Setsudan;

namespace
{
/** tridiag(-1, 2, -1), with less on the diagonal at some places. */
void
make_matrix(const std::vector<unsigned int> &places, LA::SparseMatrix &matrix)
{
  constexpr unsigned int n    = 40;
  const MPI_Comm communicator = MPI_COMM_WORLD;
  const unsigned int n_processes =
    Utilities::MPI::n_mpi_processes(communicator);
  const unsigned int process = Utilities::MPI::this_mpi_process(communicator);
  IndexSet owned(n);
  owned.add_range(n * process / n_processes, n * (process + 1) / n_processes);
  TrilinosWrappers::SparsityPattern pattern(owned, communicator);
  for (const auto i : owned)
    for (int j = std::max<int>(i - 1, 0); j < std::min<int>(i + 2, n); ++j)
      pattern.add(i, j);
  pattern.compress();
  matrix.reinit(pattern);
  for (const auto i : owned)
    for (int j = std::max<int>(i - 1, 0); j < std::min<int>(i + 2, n); ++j)
      {
        const bool is_lower =
          int(i) == j && std::count(places.begin(), places.end(), i) > 0;
        matrix.set(i, j, int(i) == j ? (is_lower ? -3. : 2.) : -1.);
      }
  matrix.compress(VectorOperation::insert);
}



void
solve(const std::vector<unsigned int> &places, const bool is_definite)
{
  LA::SparseMatrix matrix;
  make_matrix(places, matrix);
  MumpsSolver solver(50, is_definite);
  try
    {
      solver.initialize(matrix, {});
    }
  catch (const NotDefiniteError &)
    {
      if (is_first_process())
        std::cout << "not positive definite" << std::endl;
      return;
    }
  LA::Vector x(matrix.locally_owned_domain_indices(), MPI_COMM_WORLD), b = x;
  for (const auto i : matrix.locally_owned_domain_indices())
    x(i) = std::sin(1. + i);
  x.compress(VectorOperation::insert);
  matrix.vmult(b, x);
  LA::Vector found = x;
  found            = 0;
  solver.solve(found, b);
  found -= x;
  const double error = found.linfty_norm();
  if (is_first_process())
    std::cout << solver.n_negative()
              << " negative, error below 1e-11: " << (error < 1e-11)
              << std::endl;
}
} // namespace


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    solve({}, true);
    solve({}, false);
    solve({5}, true);
    solve({5, 20}, false);
    solve({5, 20, 30}, false);
  });
}
