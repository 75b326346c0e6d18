// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/assembled_solver.h>
#include <setsudan/space/near_null_space.h>

#include <sstream>

namespace Setsudan
{
using namespace dealii;

template <int dim>
AssembledSolver<dim>::AssembledSolver(
  const ElasticModel<dim> &model,
  const AffineConstraints<double> &constraints,
  const SolverParameters &parameters,
  const SolverKind kind)
  : ConstrainedSolver<dim>(model, constraints, parameters)
  , kind(kind)
  , solver(make_linear_solver(kind, parameters))
{
  if (model.is_linear())
    linearize({});
}



template <int dim>
void
AssembledSolver<dim>::linearize(const Linearization &linearization)
{
  assemble_tangent(model, linearization, constraints, matrix);
  solver->initialize(
    matrix,
    solver->is_iterative()
      ? rigid_modes_at<dim>(model.discretization.dof_locations())
      : std::vector<std::vector<double>>());
}



template <int dim>
double
AssembledSolver<dim>::round_off() const
{
  return round_off_of_forces(model.discretization, matrix.linfty_norm());
}



template <int dim>
LA::Vector
AssembledSolver<dim>::solve_condensed(const LA::Vector &b,
                                      const LA::Vector &guess,
                                      SolveQuality &quality)
{
  const double scale = b.l2_norm();
  check_loads(scale);
  LA::Vector x = guess;
  solver->solve(x, b);

  RefinedSystem system;
  system.residual_of = [&](const LA::Vector &solution) {
    LA::Vector residual = b;
    matrix.residual(residual, solution, b);
    return residual;
  };
  system.norm = [](const LA::Vector &residual) { return residual.l2_norm(); };
  system.correction = [&](const LA::Vector &residual) {
    LA::Vector correction = b;
    correction            = 0;
    solver->solve(correction, residual);
    return correction;
  };
  // After many iterations the residual that conjugate gradients carry along is
  // smaller than the true one.
  const LA::Vector residual = iterative_refinement(
    x,
    scale * (solver->is_iterative() ? accepted : refinement_threshold),
    system);

  LA::Vector correction = x;
  solver->approximate(correction, residual);
  const double norm = residual.l2_norm();
  quality           = quality_of(x, correction, norm, scale);
  if (!converged(norm, scale, matrix.linfty_norm(), x, accepted))
    fail(quality.residual);
  return x;
}



template <int dim>
void
AssembledSolver<dim>::fail(const double residual) const
{
  std::ostringstream message;
  message << "The " << description(kind)
          << " solver left a relative residual of " << residual
          << ", which must not exceed " << accepted
          << ": the system is singular or nearly so. Check that supports hold "
             "the body, and that stiffnesses do not differ beyond measure.";
  throw SolverError(message.str());
}



template class AssembledSolver<2>;
template class AssembledSolver<3>;
} // namespace Setsudan
