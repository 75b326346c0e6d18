// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/solver/assembled_solver.h>
#include <setsudan/space/near_null_space.h>

#include <algorithm>
#include <cmath>
#include <limits>
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
AssembledSolver<dim>::linearize(const Linearization &linearization,
                                const double shift)
{
  assemble_tangent(model, linearization, constraints, matrix);
  if (shift > 0)
    {
      double sum = 0;
      for (const auto i : matrix.locally_owned_range_indices())
        sum += std::abs(matrix.diag_element(i));
      sum = Utilities::MPI::sum(sum, model.discretization.communicator);
      for (const auto i : matrix.locally_owned_range_indices())
        matrix.add(i, i, shift * sum / matrix.m());
      matrix.compress(VectorOperation::add);
    }
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
  double squares = 0;
  for (const auto &[position, component] : model.discretization.dof_locations())
    squares += position[component] * position[component];
  squares = Utilities::MPI::sum(squares, model.discretization.communicator);
  return std::numeric_limits<double>::epsilon() * matrix.linfty_norm() *
         std::sqrt(squares);
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
