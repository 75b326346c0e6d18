// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/parameters/exceptions.h>
#include <setsudan/simulation/travel.h>

#include <cmath>
#include <sstream>

namespace Setsudan
{
template <int dim>
double
goal_of_travel(const CutBody<dim> &body, const BladeMotion &motion)
{
  const auto &scene = body.scene();
  const auto &stops = scene.blade.path.stops;
  return motion.n_stops < stops.size()
           ? stops[motion.n_stops].position
           : last_travel_on_board(scene.board, scene.body.mesh, body.cut());
}



double
duration_of_rest(const BladePath &way, const BladeMotion &motion)
{
  const bool rests = motion.n_stops < way.stops.size() &&
                     way.stops[motion.n_stops].position == motion.travel &&
                     way.begin_of(motion.n_stops) == motion.travel;
  return rests ? way.stops[motion.n_stops].duration : 0;
}



template <int dim>
void
set_contact(const ContactPath<dim> &path, BladeMotion &motion)
{
  const auto forces     = path.resultants();
  motion.edge_force     = forces.edge(motion.travel);
  motion.flank_force    = forces.flanks(motion.travel);
  motion.friction_force = forces.friction(motion.travel);
  motion.force_along    = forces.aside(motion.travel);
  motion.contact_area   = path.contact_area();
  motion.shift          = path.shift(motion.travel);
  motion.contacts       = path.contacts();
}



void
book_split(const double released,
           const double taken,
           const double friction,
           BladeMotion &motion)
{
  motion.time_of_split = motion.time;
  motion.surface_energy += taken;
  motion.friction_energy += friction;
  motion.excess_energy += released - taken;
  motion.n_rows_to_split = 0;
}



template <int dim>
void
give_back(const State<dim> &from, State<dim> &state)
{
  state.blade.row.reset();
  state.motion = from.motion;
  state.motion->work += energy_under_loads(state) - energy_under_loads(from);
  state.motion->edge_force       = state.motion->flank_force =
    state.motion->friction_force = state.motion->force_along =
      state.motion->contact_area = 0;
}



template <int dim>
void
check_energy_of_blade(const CutBody<dim> &body,
                      const State<dim> &state,
                      const double tolerance,
                      const double scale)
{
  const BladeMotion &motion = *state.motion;
  const double stored       = energy_under_loads(state) - motion.energy_at_rest;
  const double lost         = motion.work - stored - motion.surface_energy -
                      motion.friction_energy - motion.excess_energy;
  // The loads of a piece that has been dropped are gone.
  if (!body.floating_pieces().empty() ||
      std::abs(lost) <= tolerance * (std::abs(motion.work) +
                                     std::abs(motion.energy_at_rest) + scale))
    return;
  std::ostringstream message;
  message << "The energy of the blade does not close: of its work of "
          << motion.work << " the body stores " << stored
          << ", new surface takes " << motion.surface_energy << ", friction "
          << motion.friction_energy << " and unstable releases "
          << motion.excess_energy << ", and " << lost << " is missing. "
          << (body.model().is_linear()
                ? "The solution is not to be trusted."
                : "Let it take smaller steps: set Blade/Advance.");
  throw InvariantError(message.str());
}



template double
goal_of_travel(const CutBody<2> &, const BladeMotion &);
template double
goal_of_travel(const CutBody<3> &, const BladeMotion &);
template void
set_contact(const ContactPath<2> &, BladeMotion &);
template void
set_contact(const ContactPath<3> &, BladeMotion &);
template void
give_back(const State<2> &, State<2> &);
template void
give_back(const State<3> &, State<3> &);
template void
check_energy_of_blade(const CutBody<2> &,
                      const State<2> &,
                      const double,
                      const double);
template void
check_energy_of_blade(const CutBody<3> &,
                      const State<3> &,
                      const double,
                      const double);
} // namespace Setsudan
