// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/constrained_solver.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

template <int dim>
ConstrainedSolver<dim>::ConstrainedSolver(
  const ElasticModel<dim> &model,
  const AffineConstraints<double> &constraints,
  const SolverParameters &parameters)
  : model(model)
  , constraints(constraints)
  // The iteration's own residual differs a little from the true one.
  , accepted(std::max(failure_threshold, 2 * parameters.tolerance))
{
}



template <int dim>
LA::Vector
ConstrainedSolver<dim>::increment(const LA::Vector &residual,
                                  const LA::Vector &guess,
                                  SolveQuality &quality)
{
  LA::Vector start = guess;
  constraints.set_zero(start);
  LA::Vector x =
    solve_condensed(condense(constraints, residual), start, quality);
  distribute(constraints, x);
  return x;
}



template <int dim>
Solution
ConstrainedSolver<dim>::solve(const LA::Vector &forces,
                              const LA::Vector &lift,
                              const LA::Vector &guess)
{
  LA::Vector residual = forces;
  residual -= internal_forces(model, lift);
  LA::Vector beyond_lift = guess;
  beyond_lift -= lift;

  Solution solution;
  solution.displacement = increment(residual, beyond_lift, solution.quality);
  solution.displacement += lift;
  solution.internal = internal_forces(model, solution.displacement);
  return solution;
}



template class ConstrainedSolver<2>;
template class ConstrainedSolver<3>;
} // namespace Setsudan
