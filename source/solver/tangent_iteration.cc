// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mechanics/law_kernel.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/solver/condensed/condensed_solver.h>
#include <setsudan/solver/multigrid/p_multigrid.h>
#include <setsudan/solver/solver_choice.h>
#include <setsudan/solver/tangent_iteration.h>

#include <cmath>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

template <int dim>
TangentIteration<dim>::TangentIteration(
  const ElasticModel<dim> &model,
  const AffineConstraints<double> &constraints,
  const SolverParameters &parameters,
  std::shared_ptr<CondensedSolver<dim>> factor_of_cut)
  : ConstrainedSolver<dim>(model, constraints, parameters)
  , factor(std::move(factor_of_cut))
  , has_kernel(has_law_kernel(model))
{
  model.batches().add_ghost_indices(constraints.get_local_lines());
  local_constraints = std::make_unique<const LocalConstraints>(
    constraints, *model.batches().partitioner());
  if (!factor)
    make_multigrid(nullptr);
}



template <int dim>
TangentIteration<dim>::~TangentIteration() = default;


template <int dim>
void
TangentIteration<dim>::make_multigrid(std::shared_ptr<const Tangent> about)
{
  multigrid.reset();
  of_multigrid = std::make_unique<const ConstrainedStiffness<dim>>(
    model.discretization, model.batches(), *local_constraints, about);
  multigrid = std::make_unique<const PMultigrid<dim>>(
    *of_multigrid,
    std::make_shared<const CoarseCorrection<dim>>(
      model, constraints, *local_constraints, about));
}



template <int dim>
void
TangentIteration<dim>::linearize(const Linearization &linearization,
                                 const double accuracy)
{
  tolerance = accuracy;
  present   = linearization;
  if (!has_kernel)
    {
      assemble_tangent(model, linearization, constraints, assembled);
      return;
    }
  // Before there is another one, which is as large.
  matrix.reset();
  tangent.reset();
  tangent = tangent_by_kernel(model, linearization);
  matrix  = std::make_unique<const ConstrainedStiffness<dim>>(
    model.discretization, model.batches(), *local_constraints, tangent);
}



template <int dim>
void
TangentIteration<dim>::multiply(Vector &result, const Vector &direction) const
{
  if (has_kernel)
    {
      matrix->vmult(result, direction);
      return;
    }
  const auto &batches = model.batches();
  const LA::Vector x  = batches.copy_out(direction);
  LA::Vector product  = x;
  assembled.vmult(product, x);
  result = batches.copy_in(product);
}



template <int dim>
void
TangentIteration<dim>::precondition(Vector &result,
                                    const Vector &residual) const
{
  if (!factor)
    {
      multigrid->vmult(result, residual);
      return;
    }
  const auto &batches = model.batches();
  result = batches.copy_in(factor->correction(batches.copy_out(residual)));
  for (const unsigned int place : local_constraints->owned())
    result.local_element(place) = 0;
}



template <int dim>
void
TangentIteration<dim>::precondition_anew()
{
  if (factor)
    factor->linearize(present);
  else
    make_multigrid(tangent);
}



template <int dim>
bool
TangentIteration<dim>::iterate(Vector &x,
                               Vector &residual,
                               const double wanted,
                               const unsigned int most)
{
  if (residual.l2_norm() <= wanted)
    return true;
  Vector direction(x), forces(x), corrected(x);
  precondition(corrected, residual);
  direction      = corrected;
  double product = residual * corrected;
  for (unsigned int i = 0; i < most; ++i)
    {
      multiply(forces, direction);
      const double curvature = direction * forces;
      ++iterations;
      if (!(curvature > 0 && product > 0))
        throw NotDefiniteError(
          "Conjugate gradients met a tangent that is not positive definite.");
      x.add(product / curvature, direction);
      residual.add(-product / curvature, forces);
      if (residual.l2_norm() <= wanted)
        return true;
      precondition(corrected, residual);
      const double before = product;
      product             = residual * corrected;
      direction.sadd(product / before, 1., corrected);
    }
  return false;
}



template <int dim>
LA::Vector
TangentIteration<dim>::solve_condensed(const LA::Vector &b,
                                       const LA::Vector &,
                                       SolveQuality &quality)
{
  // A preconditioner that fits takes a fifth to a quarter of the residual away
  // in each iteration and more; one that takes three times as many is worse
  // than another set-up.
  const unsigned int few = 6 - 3 * std::log(tolerance);
  const double scale     = b.l2_norm();
  check_loads(scale);
  const auto &batches = model.batches();
  Vector residual     = batches.copy_in(b), x(residual);
  x                   = 0;
  bool done           = iterate(x, residual, tolerance * scale, few);
  if (!done)
    {
      precondition_anew();
      done = iterate(x, residual, tolerance * scale, most_multigrid_iterations);
    }
  quality.residual = scale > 0 ? residual.l2_norm() / scale : 0;
  if (!done)
    {
      std::ostringstream message;
      message << "Conjugate gradients with the tangent left a relative "
                 "residual of "
              << quality.residual << " after " << iterations << " iterations.";
      throw SolverError(message.str());
    }
  return batches.copy_out(x);
}



template class TangentIteration<2>;
template class TangentIteration<3>;
} // namespace Setsudan
