// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mechanics/stress/deformation_extremes.h>
#include <setsudan/mechanics/stress/ellipticity.h>
#include <setsudan/mesh/geometry.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/solver/no_equilibrium.h>
#include <setsudan/solver/softest_mode.h>

#include <algorithm>
#include <cmath>
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



} // namespace


bool
succeeds(const std::function<bool()> &attempt,
         std::optional<SolverError> &failure)
{
  failure.reset();
  try
    {
      return attempt();
    }
  catch (const NotDefiniteError &)
    {
      // As a failure of the steps may mean too.
    }
  catch (const SolverError &error)
    {
      failure.emplace(error);
    }
  return false;
}



double
follow_in_parts(
  const std::function<std::optional<unsigned int>(double, double)> &go_on)
{
  double behind = 0, length = 1;
  while (behind < 1)
    {
      const double part = std::min(behind + length, 1.);
      if (const auto n_steps = go_on(behind, part))
        {
          if (*n_steps <= few_steps)
            length *= 1.5;
          behind = part;
        }
      else if (length /= 2; length < smallest_part)
        break;
    }
  return behind;
}



template <int dim>
void
throw_no_equilibrium(const ElasticModel<dim> &model,
                     const AffineConstraints<double> &constraints,
                     const SolverParameters &parameters,
                     const LA::Vector &last,
                     const double part)
{
  // A volume, or resistance of a law, that is nearly nothing is why, and no
  // softness elsewhere.
  constexpr double nearly_nothing = 0.2;
  const bool is_finite            = model.materials.finite_strain;
  const auto volume               = find_smallest_volume(model, last);
  std::ostringstream message;
  message.precision(3);
  message << "There is no stable equilibrium beyond " << part
          << " of the way from the last state to this one. ";
  if (is_finite && volume.ratio < nearly_nothing)
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



template void
throw_no_equilibrium(const ElasticModel<2> &,
                     const AffineConstraints<double> &,
                     const SolverParameters &,
                     const LA::Vector &,
                     const double);
template void
throw_no_equilibrium(const ElasticModel<3> &,
                     const AffineConstraints<double> &,
                     const SolverParameters &,
                     const LA::Vector &,
                     const double);
} // namespace Setsudan
