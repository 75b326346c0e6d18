// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mechanics/stress/deformation_extremes.h>
#include <setsudan/mesh/geometry.h>
#include <setsudan/solver/assembled_solver.h>
#include <setsudan/solver/newton_solver.h>
#include <setsudan/solver/softest_mode.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
// Steps within a part. Where the extrapolated tangent takes more it does not
// converge.
constexpr unsigned int most_extrapolated_steps = 10;
constexpr unsigned int most_exact_steps        = 20;
/** A part that takes no more steps than that is followed by a larger one. */
constexpr unsigned int few_steps = 6;
/** The smallest part. */
constexpr double smallest_part = 1. / 256;

/** A displacement on the way. */
struct Iterate
{
  LA::Vector displacement;
  InternalForces internal;
  /** Condensed, and its norm beside that of the forces. */
  LA::Vector residual;
  double relative_residual = 0;
  /** The potential energy under the forces. */
  double potential = 0;
  /** The steps that led to it. */
  unsigned int n_steps = 0;

  bool
  is_valid() const
  {
    return std::isfinite(internal.energy);
  }
};



/** One solve. */
template <int dim>
class Newton
{
public:
  using Constraints = AffineConstraints<double>;

  Newton(const ElasticModel<dim> &model,
         const Constraints &constraints,
         const SolverParameters &parameters,
         const LA::Vector &forces,
         const LA::Vector &lift,
         const LA::Vector &start);

  Solution
  solve();

private:
  enum class Tangent
  {
    extrapolated,
    exact
  };

  /** The forces when a part of the way is behind. */
  LA::Vector
  forces_at(const double part) const;

  Iterate
  evaluate(const LA::Vector &displacement, const double part) const;

  bool
  is_solved(const Iterate &now, const Iterate &before) const;

  /** Follow the way from one part to another; nothing where that fails.
   *
   * @param from solved. */
  std::optional<Iterate>
  go(const Iterate &from,
     const double part_of_from,
     const double part,
     const Tangent tangent);

  /** Take the step that a residual asks for, as far as the energy falls;
   * nothing where it does not. */
  std::optional<Iterate>
  search(const Iterate &from, const LA::Vector &step, const double part) const;

  /** Set the tangent, and solve with it.
   *
   * @param may_be_indefinite whether that is no failure. */
  LA::Vector
  step(const Linearization &linearization,
       const LA::Vector &residual,
       const bool may_be_indefinite);

  /** Whether the exact tangent is positive definite. */
  bool
  is_stable(const LA::Vector &displacement);

  [[noreturn]] void
  give_up(const Iterate &last, const double part);

  const ElasticModel<dim> &model;
  const Constraints &constraints;
  const SolverParameters &parameters;
  const LA::Vector &forces;
  const LA::Vector &start;
  /** The residual at the start, and what is prescribed and lacking there. */
  LA::Vector lacking_forces;
  LA::Vector lacking_displacement;
  double size_of_forces = 0;
  AssembledSolver<dim> solver;
  /** Of matrices that are not definite; made where there are any. */
  std::unique_ptr<AssembledSolver<dim>> indefinite_solver;
  bool last_was_definite = true;
  SolveQuality quality;
  unsigned int n_steps = 0;
};



template <int dim>
Newton<dim>::Newton(const ElasticModel<dim> &model,
                    const Constraints &constraints,
                    const SolverParameters &parameters,
                    const LA::Vector &forces,
                    const LA::Vector &lift,
                    const LA::Vector &start)
  : model(model)
  , constraints(constraints)
  , parameters(parameters)
  , forces(forces)
  , start(start)
  , lacking_forces(forces)
  , lacking_displacement(lift)
  , solver(model,
           constraints,
           parameters,
           choose_assembled(parameters, size_of(model.discretization)))
{
  lacking_forces -= internal_forces(model, start);
  // What is prescribed, and from there on what the constraints allow.
  LA::Vector free_part = start;
  free_part -= lift;
  constraints.set_zero(free_part);
  distribute(constraints, free_part);
  lacking_displacement += free_part;
  lacking_displacement -= start;
}



template <int dim>
LA::Vector
Newton<dim>::forces_at(const double part) const
{
  LA::Vector result = forces;
  result.add(part - 1, lacking_forces);
  return result;
}



template <int dim>
Iterate
Newton<dim>::evaluate(const LA::Vector &displacement, const double part) const
{
  Iterate now;
  now.displacement = displacement;
  now.internal     = evaluate_laws(model, displacement);
  if (!now.is_valid())
    return now;
  now.residual  = forces_at(part);
  now.potential = now.internal.energy + now.internal.potential_of_pressure -
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
Newton<dim>::is_solved(const Iterate &now, const Iterate &before) const
{
  // Close to a solution a step squares the residual, unless that is round-off.
  const bool is_round_off =
    now.relative_residual < failure_threshold &&
    now.relative_residual > before.relative_residual / 4;
  return now.relative_residual <= parameters.tolerance || is_round_off;
}



template <int dim>
LA::Vector
Newton<dim>::step(const Linearization &linearization,
                  const LA::Vector &residual,
                  const bool may_be_indefinite)
{
  const LA::Vector zero = model.discretization.zero_vector();
  last_was_definite     = true;
  try
    {
      solver.linearize(linearization);
      return solver.increment(residual, zero, quality);
    }
  catch (const NotDefiniteError &)
    {
      if (!may_be_indefinite)
        throw;
    }
  last_was_definite = false;
  if (!indefinite_solver)
    indefinite_solver = std::make_unique<AssembledSolver<dim>>(
      model, constraints, parameters, SolverKind::indefinite);
  indefinite_solver->linearize(linearization);
  return indefinite_solver->increment(residual, zero, quality);
}



template <int dim>
bool
Newton<dim>::is_stable(const LA::Vector &displacement)
{
  try
    {
      solver.linearize({&displacement});
      return true;
    }
  catch (const NotDefiniteError &)
    {
      return false;
    }
}



template <int dim>
std::optional<Iterate>
Newton<dim>::search(const Iterate &from,
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
      Iterate tried = evaluate(displacement, part);
      if (tried.is_valid() &&
          (tried.potential <= from.potential - least_share * length * slope ||
           tried.relative_residual < from.relative_residual))
        return tried;
    }
  return {};
}



template <int dim>
std::optional<Iterate>
Newton<dim>::go(const Iterate &from,
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
  Iterate before           = from;
  before.relative_residual = 1;
  LA::Vector displacement  = from.displacement;
  displacement += prescribed;
  displacement += step({&from.displacement}, residual, extrapolates);
  Iterate now = evaluate(displacement, part);
  for (now.n_steps = 1; now.is_valid(); ++now.n_steps)
    {
      if (is_solved(now, before))
        return last_was_definite || is_stable(now.displacement)
                 ? now
                 : std::optional<Iterate>();
      if (now.n_steps == most)
        break;
      const LA::Vector increment =
        step({&now.displacement, extrapolates ? &before.displacement : nullptr},
             now.residual,
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



template <int dim>
Solution
Newton<dim>::solve()
{
  size_of_forces = 0;
  Iterate last   = evaluate(start, 0);
  size_of_forces = last.internal.forces.l2_norm();
  double part = 0, length = 1;
  while (part < 1)
    {
      const double next = std::min(part + length, 1.);
      std::optional<Iterate> reached;
      for (const auto tangent : {Tangent::extrapolated, Tangent::exact})
        if (!reached)
          try
            {
              reached = go(last, part, next, tangent);
              if (reached &&
                  find_smallest_volume(model, reached->displacement).ratio <= 0)
                reached.reset();
            }
          catch (const NotDefiniteError &)
            {
            }
      if (reached)
        {
          n_steps += reached->n_steps;
          if (reached->n_steps <= few_steps)
            length *= 1.5;
          last = std::move(*reached);
          part = next;
        }
      else if (length /= 2; length < smallest_part)
        give_up(last, part);
    }
  Solution solution;
  solution.n_steps      = n_steps;
  quality.residual      = last.relative_residual;
  quality.force_scale   = size_of_forces;
  solution.displacement = std::move(last.displacement);
  solution.internal     = std::move(last.internal.forces);
  solution.quality      = quality;
  return solution;
}



template <int dim>
void
Newton<dim>::give_up(const Iterate &last, const double part)
{
  // A volume that is nearly nothing is why, and no softness elsewhere.
  constexpr double nearly_nothing = 0.2;
  const auto volume = find_smallest_volume(model, last.displacement);
  std::ostringstream message;
  message.precision(3);
  message << "There is no stable equilibrium beyond " << part
          << " of the way from the last state to this one. ";
  if (volume.ratio < nearly_nothing)
    message << "Element " << volume.element << " is pressed to " << volume.ratio
            << " of its volume at its node " << text_of(volume.node)
            << " there: a force at a node or on a line presses a fine mesh "
               "through itself. Spread the load, lower it, or take larger "
               "elements.";
  else
    {
      const auto softest =
        softest_mode(model, constraints, parameters, last.displacement);
      message << "There the body gives way along (";
      for (unsigned int c = 0; c < dim; ++c)
        message << (c == 0 ? "" : ", ")
                << std::round(100 * softest.direction[c]) / 100;
      message << ") at " << text_of(softest.node)
              << " without more load. Hold it, or lower the load.";
    }
  throw NoEquilibriumError(message.str());
}
} // namespace


template <int dim>
NewtonSolver<dim>::NewtonSolver(const ElasticModel<dim> &model,
                                std::shared_ptr<const Constraints> constraints,
                                const SolverParameters &parameters)
  : model(model)
  , constraints(std::move(constraints))
  , parameters(parameters)
{
}



template <int dim>
Solution
NewtonSolver<dim>::solve(const LA::Vector &forces,
                         const LA::Vector &lift,
                         const LA::Vector &start)
{
  return Newton<dim>(model, *constraints, parameters, forces, lift, start)
    .solve();
}



template class NewtonSolver<2>;
template class NewtonSolver<3>;
} // namespace Setsudan
