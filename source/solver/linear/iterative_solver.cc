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
  bool is_definite = true;
  SolverCG<LA::Vector> solver(control);
  // Approximations of those of the preconditioned matrix.
  solver.connect_eigenvalues_slot([&](const std::vector<double> &eigenvalues) {
    is_definite =
      eigenvalues.empty() || eigenvalues.front() > -1e-12 * eigenvalues.back();
  });
  try
    {
      solver.solve(*matrix, x, b, multigrid);
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
  if (!is_definite)
    throw NotDefiniteError("Conjugate gradients met a matrix that is not "
                           "positive definite. Check that supports hold the "
                           "body.");
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
