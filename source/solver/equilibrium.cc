#include <setsudan/elasticity/rigid_modes.h>
#include <setsudan/solver/equilibrium.h>

#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
// A direct solve whose residual exceeds the first is refined once; a solve
// whose residual exceeds the second has failed.
constexpr double refined_above = 1e-13;
constexpr double failed_above  = 1e-8;


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
  , solver(
      make_linear_solver(parameters, model.discretization.dof_handler.n_dofs()))
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
  solver->solve(x, b);

  LA::Vector residual      = b;
  const auto residual_norm = [&]() {
    matrix.residual(residual, x, b);
    return residual.l2_norm();
  };
  const double scale = b.l2_norm();
  double error       = residual_norm();
  if (!solver->is_iterative() && error > refined_above * scale)
    {
      LA::Vector correction = b;
      solver->solve(correction, residual);
      x += correction;
      error = residual_norm();
    }
  // Written so that a residual that is not a number fails as well.
  if (!(error <= failed_above * scale))
    {
      std::ostringstream message;
      message << "The " << solver->description()
              << " solver left a relative residual of " << error / scale
              << ", which must not exceed " << failed_above
              << ": the system is singular or nearly so. Check that supports "
                 "hold the body.";
      throw SolverError(message.str());
    }
  constraints.distribute(x);
  x += prescribed;
  return x;
}



template class Equilibrium<2>;
template class Equilibrium<3>;
} // namespace Setsudan
