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
Solution
ConstrainedSolver<dim>::solve(const LA::Vector &forces,
                              const LA::Vector &lift,
                              const LA::Vector &guess)
{
  LA::Vector residual = forces;
  residual -= internal_forces(model, lift);

  Solution solution;
  LA::Vector &x = solution.displacement;
  x             = guess;
  x -= lift;
  constraints.set_zero(x);
  x = solve_condensed(condense(constraints, residual), x, solution.quality);
  distribute(constraints, x);
  x += lift;
  solution.internal = internal_forces(model, x);
  return solution;
}



template class ConstrainedSolver<2>;
template class ConstrainedSolver<3>;
} // namespace Setsudan
