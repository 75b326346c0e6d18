// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mechanics/stress/deformation_extremes.h>
#include <setsudan/mechanics/stress/ellipticity.h>
#include <setsudan/mesh/geometry.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/solver/newton_path.h>
#include <setsudan/solver/newton_solver.h>
#include <setsudan/solver/softest_mode.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** A part that takes no more steps than that is followed by a larger one. */
constexpr unsigned int few_steps = 6;
/** The smallest part. */
constexpr double smallest_part = 1. / 256;



/**
 * Go on from one part of a way to another, with the one tangent or the other;
 * nothing where neither leads to a state that a body can be in.
 *
 * @param failure of a linear solve that was in the way of the exact tangent; is
 *   set.
 */
template <int dim>
std::optional<NewtonIterate>
try_part(const ElasticModel<dim> &model,
         NewtonPath<dim> &path,
         const NewtonIterate &from,
         const double part_of_from,
         const double part,
         std::optional<SolverError> &failure)
{
  using Tangent = typename NewtonPath<dim>::Tangent;
  for (const auto tangent : {Tangent::extrapolated, Tangent::exact})
    try
      {
        failure.reset();
        auto reached = path.go(from, part_of_from, part, tangent);
        if (reached &&
            find_smallest_volume(model, reached->displacement).ratio > 0 &&
            !turns_over(model, from.displacement, reached->displacement))
          return reached;
      }
    catch (const NotDefiniteError &)
      {
        // Not stable, as a failure of the steps may mean too.
      }
    catch (const SolverError &error)
      {
        failure.emplace(error);
      }
  return {};
}



/** Where a body gives way, as a sentence. */
template <int dim>
std::string
describe_softest_mode(const ElasticModel<dim> &model,
                      const AffineConstraints<double> &constraints,
                      const SolverParameters &parameters,
                      const LA::Vector &displacement)
{
  std::ostringstream text;
  text << "There the body gives way";
  try
    {
      const auto softest =
        softest_mode(model, constraints, parameters, displacement);
      text << " along (";
      for (unsigned int c = 0; c < dim; ++c)
        text << (c == 0 ? "" : ", ")
             << std::round(100 * softest.direction[c]) / 100;
      text << ") at " << text_of(softest.node);
    }
  catch (const SolverError &)
    {
      // The tangent is so nearly singular that it cannot be solved with.
    }
  text << " without more load. Hold it, or lower the load.";
  return text.str();
}



/** @throw NoEquilibriumError always.
 * @param last the last state that was reached. */
template <int dim>
[[noreturn]] void
give_up(const ElasticModel<dim> &model,
        const AffineConstraints<double> &constraints,
        const SolverParameters &parameters,
        const LA::Vector &last,
        const double part)
{
  // A volume, or resistance of a law, that is nearly nothing is why, and no
  // softness elsewhere.
  constexpr double nearly_nothing = 0.2;
  const auto volume               = find_smallest_volume(model, last);
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
  else if (const auto softest = find_least_ellipticity(model, last);
           softest.ratio < nearly_nothing)
    message << "There " << describe_ellipticity(model, softest);
  else
    message << describe_softest_mode(model, constraints, parameters, last);
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
  NewtonPath<dim> path(model, *constraints, parameters, forces, lift, start);
  NewtonIterate last   = path.beginning();
  unsigned int n_steps = 0;
  std::optional<SolverError> failure;
  double part = 0, length = 1;
  while (part < 1)
    {
      const double next = std::min(part + length, 1.);
      if (auto reached = try_part(model, path, last, part, next, failure))
        {
          n_steps += reached->n_steps;
          if (reached->n_steps <= few_steps)
            length *= 1.5;
          last = std::move(*reached);
          part = next;
        }
      else if (length /= 2; length < smallest_part)
        {
          if (failure)
            throw *failure;
          give_up(model, *constraints, parameters, last.displacement, part);
        }
    }
  path.quality.residual    = last.relative_residual;
  path.quality.force_scale = path.size_of_first_forces();
  return {std::move(last.displacement),
          std::move(last.internal.forces),
          path.quality,
          n_steps};
}



template class NewtonSolver<2>;
template class NewtonSolver<3>;
} // namespace Setsudan
