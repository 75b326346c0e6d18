// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/lac/solver_cg.h>

#include <setsudan/solver/linear/iterative_solver.h>

namespace Setsudan
{
using namespace dealii;

IterativeSolver::IterativeSolver(const SolverParameters &parameters)
  : parameters(parameters)
{
}



void
IterativeSolver::initialize(const LA::SparseMatrix &new_matrix,
                            const std::vector<std::vector<double>> &rigid_modes)
{
  matrix = &new_matrix;
  multigrid.initialize(matrix->trilinos_matrix(), rigid_modes);
}



void
IterativeSolver::solve(LA::Vector &x, const LA::Vector &b)
{
  const double forces = b.l2_norm();
  if (forces == 0)
    {
      x = 0;
      return;
    }
  SolverControl control(parameters.max_iterations,
                        parameters.tolerance * forces);
  try
    {
      SolverCG<LA::Vector>(control).solve(*matrix, x, b, multigrid);
    }
  catch (const SolverControl::NoConvergence &)
    {
      throw SolverError(
        "Conjugate gradients reached a relative residual of " +
        std::to_string(control.last_value() / forces) + " after " +
        std::to_string(control.last_step()) +
        " iterations and not Solver/Tolerance. Set Solver/Method = direct, or "
        "allow more iterations with Solver/Maximum iterations.");
    }
}



void
IterativeSolver::approximate(LA::Vector &x, const LA::Vector &b)
{
  multigrid.vmult(x, b);
}



bool
IterativeSolver::is_iterative() const
{
  return true;
}
} // namespace Setsudan
