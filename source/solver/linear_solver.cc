#include <setsudan/solver/direct_solver.h>
#include <setsudan/solver/iterative_solver.h>
#include <setsudan/solver/linear_solver.h>

namespace Setsudan
{
std::unique_ptr<LinearSolver>
make_linear_solver(const SolverParameters &parameters,
                   const dealii::types::global_dof_index n_unknowns)
{
  using Method      = SolverParameters::Method;
  const bool direct = parameters.method == Method::direct ||
                      (parameters.method == Method::automatic &&
                       n_unknowns <= parameters.direct_up_to);
  if (direct)
    return std::make_unique<DirectSolver>(n_unknowns);
  return std::make_unique<IterativeSolver>(parameters);
}
} // namespace Setsudan
