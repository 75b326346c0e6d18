// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mechanics/law_kernel.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/solver/condensed/condensed_solver.h>
#include <setsudan/solver/newton_path.h>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

namespace
{
// Steps within a part. Where the extrapolated tangent takes more it does not
// converge.
constexpr unsigned int most_extrapolated_steps = 10;
constexpr unsigned int most_exact_steps        = 20;
// Of the forces with which a body resists what is prescribed, a part beside
// which all others are round-off, as where supports turn a body rigidly.
constexpr double part_of_resistance = 1e-4;
} // namespace


template <int dim>
NewtonPath<dim>::NewtonPath(const ElasticModel<dim> &model,
                            const Constraints &constraints,
                            const SolverParameters &parameters,
                            const LA::Vector &forces,
                            const LA::Vector &lift,
                            const LA::Vector &start,
                            std::shared_ptr<CondensedSolver<dim>> factor)
  : model(model)
  , constraints(constraints)
  , parameters(parameters)
  , forces(forces)
  , lacking_forces(forces)
  , lacking_displacement(lift)
  , solver(model,
           constraints,
           parameters,
           choose_assembled(parameters, size_of(model.discretization)))
  , is_small(choose_tangent_solver(model, parameters) !=
             SolverKind::matrix_free)
{
  if (factor || !is_small)
    iteration = std::make_unique<TangentIteration<dim>>(
      model, constraints, parameters, std::move(factor));
  first.displacement = start;
  first.internal     = evaluate_laws(model, start);
  lacking_forces -= first.internal.forces;
  size_of_forces = first.internal.forces.l2_norm();
  // What is prescribed, and from there on what the constraints allow.
  LA::Vector free_part = start;
  free_part -= lift;
  constraints.set_zero(free_part);
  distribute(constraints, free_part);
  lacking_displacement += free_part;
  lacking_displacement -= start;
  if (lacking_displacement.linfty_norm() > 0)
    size_of_forces =
      std::max(size_of_forces,
               part_of_resistance *
                 tangent_times(model, start, lacking_displacement).l2_norm());
}



template <int dim>
LA::Vector
NewtonPath<dim>::forces_at(const double part) const
{
  LA::Vector result = forces;
  result.add(part - 1, lacking_forces);
  return result;
}



template <int dim>
NewtonIterate
NewtonPath<dim>::evaluate(const LA::Vector &displacement,
                          const double part) const
{
  NewtonIterate now;
  now.displacement = displacement;
  now.internal     = evaluate_laws(model, displacement);
  if (!now.is_valid())
    return now;
  now.residual  = forces_at(part);
  now.potential = now.internal.energy.potential +
                  now.internal.potential_of_pressure -
                  now.residual * displacement;
  // Forces of the state before are a scale where none act any more.
  const double scale =
    std::max({forces.l2_norm(), now.internal.forces.l2_norm(), size_of_forces});
  now.residual -= now.internal.forces;
  now.residual          = condense(constraints, now.residual);
  const double norm     = now.residual.l2_norm();
  now.relative_residual = scale > 0 ? norm / scale : norm;
  return now;
}



template <int dim>
bool
NewtonPath<dim>::is_solved(const NewtonIterate &now,
                           const NewtonIterate &before) const
{
  // Close to a solution a step squares the residual, unless that is round-off.
  const bool is_round_off =
    (now.relative_residual < failure_threshold ||
     now.residual.l2_norm() <= solver.round_off()) &&
    now.relative_residual > before.relative_residual / 4;
  return now.relative_residual <= parameters.tolerance || is_round_off;
}



template <int dim>
LA::Vector
NewtonPath<dim>::definite_step(const Linearization &linearization,
                               const LA::Vector &residual,
                               const double tolerance)
{
  const LA::Vector zero = model.discretization.zero_vector();
  if (iteration)
    try
      {
        iteration->linearize(linearization, tolerance);
        return iteration->increment(residual, zero, quality);
      }
    catch (const NotDefiniteError &)
      {
        throw;
      }
    catch (const SolverError &)
      {
        iteration.reset();
      }
  solver.linearize(linearization);
  return solver.increment(residual, zero, quality);
}



template <int dim>
LA::Vector
NewtonPath<dim>::step(const Linearization &linearization,
                      const LA::Vector &residual,
                      const double relative_residual,
                      const bool may_be_indefinite)
{
  // A step squares the residual at best, and no more is asked of the linear
  // solve (Eisenstat and Walker 1996, SIAM Journal on Scientific Computing 17,
  // 16-32); nor more than the last step needs.
  const double wanted = parameters.tolerance / (4 * relative_residual);
  const double tolerance =
    std::max(wanted, std::min(1e-2, relative_residual / 10));
  last_was_definite = true;
  try
    {
      return definite_step(linearization, residual, tolerance);
    }
  catch (const NotDefiniteError &)
    {
      // To factor L D L^T of a large body takes longer than to halve the part.
      if (!may_be_indefinite || !is_small)
        throw;
    }
  last_was_definite = false;
  if (!indefinite_solver)
    indefinite_solver = std::make_unique<AssembledSolver<dim>>(
      model, constraints, parameters, SolverKind::indefinite);
  indefinite_solver->linearize(linearization);
  return indefinite_solver->increment(
    residual, model.discretization.zero_vector(), quality);
}



template <int dim>
bool
NewtonPath<dim>::is_stable(const LA::Vector &displacement)
{
  // To an iteration only what it meets shows: forces that have something of
  // every eigenvector, and for most of which symmetry is no excuse.
  constexpr double accuracy = 1e-3;
  LA::Vector forces         = model.discretization.zero_vector();
  for (const auto index : model.discretization.owned)
    forces(index) = 1 + std::sin(1. + index);
  forces.compress(VectorOperation::insert);
  try
    {
      definite_step({&displacement}, forces, accuracy);
      return true;
    }
  catch (const NotDefiniteError &)
    {
      return false;
    }
}



template <int dim>
std::optional<NewtonIterate>
NewtonPath<dim>::search(const NewtonIterate &from,
                        const LA::Vector &step,
                        const double part) const
{
  // Of the fall in energy that the slope promises, what a step must bring.
  constexpr double least_share      = 1e-4;
  constexpr unsigned int most_tries = 10;
  const double slope                = step * from.residual;
  double length                     = 1;
  for (unsigned int i = 0; i < most_tries; ++i, length /= 2)
    {
      LA::Vector displacement = from.displacement;
      displacement.add(length, step);
      NewtonIterate tried = evaluate(displacement, part);
      if (tried.is_valid() &&
          (tried.potential <= from.potential - least_share * length * slope ||
           tried.relative_residual < from.relative_residual))
        return tried;
    }
  return {};
}



template <int dim>
std::optional<NewtonIterate>
NewtonPath<dim>::go(const NewtonIterate &from,
                    const double part_of_from,
                    const double part,
                    const Tangent tangent)
{
  const bool extrapolates = tangent == Tangent::extrapolated;
  const unsigned int most =
    extrapolates ? most_extrapolated_steps : most_exact_steps;
  // The first step goes to what is prescribed, too.
  LA::Vector prescribed = lacking_displacement;
  prescribed *= part - part_of_from;
  LA::Vector residual = forces_at(part);
  residual -= from.internal.forces;
  if (prescribed.linfty_norm() > 0)
    residual -= tangent_times(model, from.displacement, prescribed);
  NewtonIterate before     = from;
  before.relative_residual = 1;
  LA::Vector displacement  = from.displacement;
  displacement += prescribed;
  displacement += step({&from.displacement}, residual, 1, extrapolates);
  NewtonIterate now = evaluate(displacement, part);
  for (now.n_steps = 1; now.is_valid(); ++now.n_steps)
    {
      if (is_solved(now, before))
        {
          // The tangent of a single step is that of where it came from.
          const bool is_known_stable =
            last_was_definite && !iteration && now.n_steps > 1;
          return is_known_stable || is_stable(now.displacement)
                   ? now
                   : std::optional<NewtonIterate>();
        }
      if (now.n_steps == most)
        break;
      const LA::Vector increment =
        step({&now.displacement, extrapolates ? &before.displacement : nullptr},
             now.residual,
             now.relative_residual,
             extrapolates);
      auto next = extrapolates ? std::nullopt : search(now, increment, part);
      if (extrapolates)
        {
          displacement = now.displacement;
          displacement += increment;
          next = evaluate(displacement, part);
        }
      if (!next)
        break;
      next->n_steps = now.n_steps;
      before        = std::move(now);
      now           = std::move(*next);
    }
  return {};
}



template class NewtonPath<2>;
template class NewtonPath<3>;
} // namespace Setsudan
