// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <setsudan/solver/linear/cholesky_solver.h>
#include <setsudan/solver/linear/iterative_solver.h>
#include <setsudan/solver/linear/linear_solver.h>
#include <setsudan/solver/linear/mumps_solver.h>

namespace Setsudan
{
std::unique_ptr<LinearSolver>
make_linear_solver(const SolverKind kind, const SolverParameters &parameters)
{
  if (kind == SolverKind::cholesky)
    return std::make_unique<CholeskySolver>();
  if (kind == SolverKind::mumps)
    return std::make_unique<MumpsSolver>();
  if (kind == SolverKind::indefinite)
    return std::make_unique<MumpsSolver>(50, false);
  Assert(kind == SolverKind::algebraic_multigrid, dealii::ExcInternalError());
  return std::make_unique<IterativeSolver>(parameters);
}
} // namespace Setsudan
