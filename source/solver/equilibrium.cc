#include <setsudan/elasticity/rigid_modes.h>
#include <setsudan/solver/equilibrium.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The rigid motions in this process's unknowns, one vector each. */
template <int dim>
std::vector<std::vector<double>>
rigid_modes_of(const Discretization<dim> &discretization)
{
  const auto &sites = discretization.sites();
  std::vector<std::vector<double>> modes(n_rigid_modes<dim>,
                                         std::vector<double>(sites.size()));
  for (unsigned int i = 0; i < sites.size(); ++i)
    {
      const auto motions = rigid_modes(sites[i].position, Point<dim>(), 1.);
      for (unsigned int m = 0; m < modes.size(); ++m)
        modes[m][i] = motions[m][sites[i].component];
    }
  return modes;
}
} // namespace


template <int dim>
Equilibrium<dim>::Equilibrium(ElasticModel<dim> &model,
                              const AffineConstraints<double> &constraints,
                              const SolverParameters &parameters)
  : model(model)
  , constraints(constraints)
  // The iteration's own residual differs a little from the true one.
  , accepted(std::max(failed_above, 2 * parameters.tolerance))
  , solver(make_linear_solver(parameters,
                              model.discretization.dof_handler.n_dofs(),
                              model.discretization.communicator))
{
  assemble_stiffness(
    model.discretization, model.stiffness, constraints, matrix);
  solver->initialize(matrix,
                     solver->is_iterative()
                       ? rigid_modes_of(model.discretization)
                       : std::vector<std::vector<double>>());
}



template <int dim>
LA::Vector
Equilibrium<dim>::solve(const LA::Vector &forces,
                        const LA::Vector &prescribed,
                        const LA::Vector &guess)
{
  LA::Vector remaining = forces;
  remaining -= internal_forces(model.discretization,
                               model.stiffness,
                               model.discretization.with_ghosts(prescribed));
  const LA::Vector b = condense(constraints, remaining);

  LA::Vector x = guess;
  x -= prescribed;
  constraints.set_zero(x);
  x = solve_condensed(b, x);
  constraints.distribute(x);
  x += prescribed;
  return x;
}



template <int dim>
LA::Vector
Equilibrium<dim>::solve_condensed(const LA::Vector &b, const LA::Vector &guess)
{
  const double scale = b.l2_norm();
  if (!std::isfinite(scale))
    throw SolverError(
      "The loads exceed the range of numbers, the sum of their squares is no "
      "number. Choose units of force and length in which they are smaller.");
  LA::Vector x = guess;
  solver->solve(x, b);

  LA::Vector residual = b;
  double error        = matrix.residual(residual, x, b);
  // Conjugate gradients that went on for long take for solved what is not.
  const double wanted =
    scale * (solver->is_iterative() ? accepted : refined_above);
  for (unsigned int n = 0; n < max_refinements && error > wanted; ++n)
    {
      LA::Vector better = b;
      better            = 0;
      solver->solve(better, residual);
      better += x;
      LA::Vector new_residual = b;
      const double new_error  = matrix.residual(new_residual, better, b);
      if (!(new_error < error))
        break;
      const bool converges = new_error < error / 2;
      x                    = better;
      residual             = new_residual;
      error                = new_error;
      if (!converges)
        break;
    }
  assess(x, residual, scale);

  if (!is_accepted(error, scale, matrix.linfty_norm(), x, accepted))
    fail();
  return x;
}



template <int dim>
void
Equilibrium<dim>::assess(const LA::Vector &x,
                         const LA::Vector &residual,
                         const double scale)
{
  LA::Vector error = x;
  solver->approximate(error, residual);
  const double largest = x.linfty_norm();
  quality.residual     = scale > 0 ? residual.l2_norm() / scale : 0;
  quality.uncertainty  = largest > 0 ? error.linfty_norm() / largest : 0;
}



template <int dim>
SolveQuality
Equilibrium<dim>::quality_of_last() const
{
  return quality;
}



template <int dim>
void
Equilibrium<dim>::fail() const
{
  std::ostringstream message;
  message << "The " << solver->description()
          << " solver left a relative residual of " << quality.residual
          << ", which must not exceed " << accepted
          << ": the system is singular or nearly so. Check that supports hold "
             "the body, and that stiffnesses do not differ beyond measure.";
  throw SolverError(message.str());
}



template class Equilibrium<2>;
template class Equilibrium<3>;
} // namespace Setsudan
