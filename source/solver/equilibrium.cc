// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/assembled_solver.h>
#include <setsudan/solver/equilibrium.h>

#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
// More steps than a law with a smooth tangent ever needs.
constexpr unsigned int most_newton_steps = 20;
} // namespace


template <int dim>
Solution
solve_linear(const EquilibriumProblem<dim> &problem,
             TangentSolver &solver,
             const LA::Vector &guess)
{
  return solver.solve(problem.forces, problem.lift, guess);
}



template <int dim>
Solution
solve_newton(const EquilibriumProblem<dim> &problem,
             const SolverParameters &parameters,
             const LA::Vector &start)
{
  const auto &model       = problem.model;
  const auto &constraints = *problem.constraints;
  const LA::Vector zero   = model.discretization.zero_vector();
  const SolverKind kind =
    choose_assembled(parameters, size_of(model.discretization));
  Solution solution;
  LA::Vector &u = solution.displacement;
  // What is prescribed, and from there on what the constraints allow.
  LA::Vector free_part = start;
  free_part -= problem.lift;
  constraints.set_zero(free_part);
  distribute(constraints, free_part);
  u = problem.lift;
  u += free_part;
  for (unsigned int step = 0; step <= most_newton_steps; ++step)
    {
      solution.internal   = internal_forces(model, u);
      LA::Vector residual = problem.forces;
      residual -= solution.internal;
      const double norm = condense(constraints, residual).l2_norm();
      const double scale =
        std::max(problem.forces.l2_norm(), solution.internal.l2_norm());
      solution.quality.residual = scale > 0 ? norm / scale : 0;
      if (norm <= parameters.tolerance * scale)
        return solution;
      u += AssembledSolver<dim>(model, constraints, parameters, kind, &u)
             .increment(residual, zero, solution.quality);
    }
  std::ostringstream message;
  message << "Newton's method left a relative residual of "
          << solution.quality.residual << " after " << most_newton_steps
          << " steps. Lower the load, or apply it in steps.";
  throw SolverError(message.str());
}



template Solution
solve_linear(const EquilibriumProblem<2> &,
             TangentSolver &,
             const LA::Vector &);
template Solution
solve_linear(const EquilibriumProblem<3> &,
             TangentSolver &,
             const LA::Vector &);
template Solution
solve_newton(const EquilibriumProblem<2> &,
             const SolverParameters &,
             const LA::Vector &);
template Solution
solve_newton(const EquilibriumProblem<3> &,
             const SolverParameters &,
             const LA::Vector &);
} // namespace Setsudan
