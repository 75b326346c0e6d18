// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/parameters/exceptions.h>
#include <setsudan/simulation/nonlinear_ramp.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>

namespace Setsudan
{
namespace
{
/** By how much a state exceeds what is required, relative to that. */
template <int dim>
double
excess(const State<dim> &state)
{
  const auto &[reached, required] = state.stress;
  return required > 0 ? reached / required - 1 : reached;
}
} // namespace


template <int dim>
typename NonlinearRamp<dim>::Bracket
NonlinearRamp<dim>::bracket(CutBody<dim> &body,
                            const unsigned int row,
                            const State<dim> &from) const
{
  // Of the largest factor, the first one that is tried.
  constexpr double first_part = 1. / 16;
  // Where the way to a factor has no equilibria, the distance at which that is
  // known well enough.
  constexpr double nearly = 1e-3;
  const double most       = this->scene.division.max_load_factor;
  double ceiling          = most;
  State<dim> below        = this->checked_state(body, row, 0, from);
  double next = from.load_factor > 0 ? std::min(from.load_factor / 2, most)
                                     : most * first_part;
  while (!below.yields && below.load_factor < most)
    try
      {
        State<dim> tried = this->checked_state(body, row, next, below);
        if (tried.yields)
          return {below, tried};
        // Along the line through both, a little further.
        const double slope = (excess(tried) - excess(below)) /
                             (tried.load_factor - below.load_factor);
        const double step = slope > 0 ? 1.02 * -excess(tried) / slope : ceiling;
        below             = std::move(tried);
        next =
          std::min(below.load_factor + step,
                   ceiling < most ? (below.load_factor + ceiling) / 2 : most);
      }
    catch (const NoEquilibriumError &)
      {
        ceiling = next;
        if (ceiling - below.load_factor < nearly * ceiling)
          throw;
        next = (below.load_factor + ceiling) / 2;
      }
  if (below.yields)
    return {below, below};
  return {below, {}};
}



template <int dim>
State<dim>
NonlinearRamp<dim>::advance(CutBody<dim> &body,
                            const unsigned int row,
                            const State<dim> &from)
{
  if (!this->is_checked(row))
    return this->checked_state(body, row, from.load_factor, from);
  auto [below, above] = bracket(body, row, from);
  if (!above)
    return below;
  if (above->load_factor == 0)
    return *above;
  const State<dim> start = below;
  const auto excess_at   = [&](const double factor) {
    State<dim> state  = this->checked_state(body, row, factor, start);
    const double over = excess(state);
    if (state.yields && factor < above->load_factor)
      above = std::move(state);
    return over;
  };
  boost::uintmax_t most_solves = 50;
  boost::math::tools::toms748_solve(
    excess_at,
    start.load_factor,
    above->load_factor,
    excess(start),
    excess(*above),
    boost::math::tools::eps_tolerance<double>(36),
    most_solves);
  return *above;
}



template class NonlinearRamp<2>;
template class NonlinearRamp<3>;
} // namespace Setsudan
