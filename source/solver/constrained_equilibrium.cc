#include <setsudan/solver/constrained_equilibrium.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

template <int dim>
ConstrainedEquilibrium<dim>::ConstrainedEquilibrium(
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
ConstrainedEquilibrium<dim>::solve(const LA::Vector &forces,
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
ConstrainedEquilibrium<dim>::quality_of_last() const
{
  return quality;
}



template class ConstrainedEquilibrium<2>;
template class ConstrainedEquilibrium<3>;
} // namespace Setsudan
