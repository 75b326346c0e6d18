#include <setsudan/solver/constrained_solver.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

template <int dim>
ConstrainedSolver<dim>::ConstrainedSolver(
  ElasticModel<dim> &model,
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
ConstrainedSolver<dim>::solve(const LA::Vector &forces,
                              const LA::Vector &prescribed,
                              const LA::Vector &guess)
{
  LA::Vector remaining = forces;
  remaining -= internal_forces(model, prescribed);
  const LA::Vector b = condense(constraints, remaining);

  LA::Vector x = guess;
  x -= prescribed;
  constraints.set_zero(x);
  x = solve_condensed(b, x);
  distribute(constraints, x);
  x += prescribed;
  return x;
}



template <int dim>
SolveQuality
ConstrainedSolver<dim>::quality_of_last() const
{
  return quality;
}



template class ConstrainedSolver<2>;
template class ConstrainedSolver<3>;
} // namespace Setsudan
