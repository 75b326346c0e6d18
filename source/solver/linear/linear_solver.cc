#include <deal.II/base/mpi.h>

#include <setsudan/solver/linear/cholesky_solver.h>
#include <setsudan/solver/linear/direct_solver.h>
#include <setsudan/solver/linear/iterative_solver.h>
#include <setsudan/solver/linear/linear_solver.h>

namespace Setsudan
{
std::unique_ptr<LinearSolver>
make_linear_solver(const SolverParameters &parameters,
                   const dealii::types::global_dof_index n_unknowns,
                   const MPI_Comm communicator)
{
  if (!parameters.is_direct(n_unknowns))
    return std::make_unique<IterativeSolver>(parameters);
  if (n_unknowns > DirectSolver::small_size &&
      dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
    return std::make_unique<CholeskySolver>();
  return std::make_unique<DirectSolver>(n_unknowns);
}
} // namespace Setsudan
