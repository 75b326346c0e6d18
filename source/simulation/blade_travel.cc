// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/parameters/exceptions.h>
#include <setsudan/simulation/blade_travel.h>
#include <setsudan/simulation/travel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Setsudan
{
using namespace dealii;

namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();

/** Move the blade on while the contacts stay as they are. */
template <int dim>
void
move_to(const double travel,
        const BladeParameters<dim> &blade,
        const ContactPath<dim> &path,
        BladeMotion &motion)
{
  const double slice  = blade.sliding.slice;
  const double speed  = blade.path.speed_to(motion.n_stops);
  const auto forces   = path.resultants();
  const auto force_at = [&](const double p) {
    return forces.edge(p) + forces.flanks(p) + slice * forces.aside(p);
  };
  motion.work +=
    (force_at(motion.travel) + force_at(travel)) / 2 * (travel - motion.travel);
  motion.unfelt_work += (forces.unfelt(motion.travel) + forces.unfelt(travel)) /
                        2 * (travel - motion.travel);
  motion.friction_energy += path.friction_work(motion.travel, travel);
  if (speed > 0)
    motion.time += std::abs(travel - motion.travel) / speed;
  motion.travel = travel;
}
} // namespace


template <int dim>
BladeTravel<dim>::BladeTravel(const Scene<dim> &scene)
  : ContactDrive<dim>(scene)
{
}



template <int dim>
std::optional<Split>
BladeTravel<dim>::follow(BladeMotion &motion, const double goal)
{
  const bool pushes = goal >= motion.travel;
  // More changes of the contact than a row has.
  constexpr unsigned int most = 1000000;
  for (unsigned int n_changes = 0; n_changes < most; ++n_changes)
    {
      const double end = pushes ? std::min({path->end(), search->end(), goal})
                                : std::max(path->end(), goal);
      // What is split closes while the blade is withdrawn, and no more splits.
      const auto split =
        pushes ? search->first_split(motion, end) : std::optional<Split>();
      const double travel = split ? split->travel : end;
      if (travel == infinity)
        return {};
      move_to(travel, this->scene.blade, *path, motion);
      if (split || travel == goal)
        return split;
      if (pushes ? path->end() <= travel : path->end() >= travel)
        motion.excess_energy += path->cross_end();
      if (pushes)
        search->cross(travel);
    }
  throw SolverError(
    "The contact of the blade does not settle at a travel of " +
    std::to_string(motion.travel) +
    ": walls go on opening and closing. Set Blade/Shoulder "
    "radius larger, or Blade/Friction or Blade/Adhesion lower.");
}



template <int dim>
State<dim>
BladeTravel<dim>::solve(CutBody<dim> &body,
                        const unsigned int row,
                        const BladeMotion &motion,
                        const State<dim> &from)
{
  constexpr double tolerance = 1e-6;
  State<dim> state =
    cut_contact->state(*path, row, motion.travel, from.displacement);
  state.motion = motion;
  set_contact(*path, *state.motion);
  check_energy_of_blade(body, state, tolerance);
  return state;
}



template <int dim>
State<dim>
BladeTravel<dim>::advance(CutBody<dim> &body,
                          const unsigned int row,
                          const State<dim> &from)
{
  BladeMotion motion = from.motion.value_or(BladeMotion());
  if (!from.motion)
    motion.energy_at_rest = from.potential_energy;
  CutContact<dim> &of_cut = this->contact(body, from);
  if (!path)
    path = of_cut.path(row, search->n_looked_ahead(body, row), motion, nullptr);
  const double goal = goal_of_travel(body, motion);
  if (goal != motion.travel)
    motion.excess_energy +=
      path->head(goal > motion.travel ? 1 : -1, motion.travel);
  if (goal >= motion.travel)
    search->begin(body, of_cut, row, *path, motion);
  const auto split       = follow(motion, goal);
  motion.n_rows_to_split = split ? split->n_rows : 0;
  if (!split && motion.n_stops < this->scene.blade.path.stops.size())
    {
      motion.time += duration_of_rest(this->scene.blade.path, motion);
      ++motion.n_stops;
    }
  State<dim> state = solve(body, row, motion, from);
  state.yields     = split.has_value();
  if (split)
    state.stress = split->stress;
  return state;
}



template <int dim>
std::optional<State<dim>>
BladeTravel<dim>::settle(CutBody<dim> &body,
                         const unsigned int row,
                         const State<dim> &from)
{
  BladeMotion motion        = *from.motion;
  const unsigned int before = row - motion.n_rows_to_split;
  CutContact<dim> &of_cut   = this->contact(body, from);
  if (!path)
    path = of_cut.path(before, row - before, motion, nullptr);
  auto split =
    of_cut.path(row, search->n_looked_ahead(body, row), motion, path.get());
  const double released = path->energy_set_free(*split)(motion.travel);
  const double taken =
    search->surface_energy(body, before, row - before, motion, released);
  book_split(
    released, taken, path->friction_work_to(*split)(motion.travel), motion);
  path = std::move(split);
  return solve(body, row, motion, from);
}



template <int dim>
State<dim>
BladeTravel<dim>::finish(CutBody<dim> &body, const State<dim> &from)
{
  CutContact<dim> &of_cut = this->contact(body, from);
  path                    = of_cut.path_without_blade(*from.motion, path.get());
  State<dim> state        = of_cut.state(
    *path, body.seam().rows().size(), from.motion->travel, from.displacement);
  give_back(from, state);
  path.reset();
  cut_contact.reset();
  return state;
}



template class BladeTravel<2>;
template class BladeTravel<3>;
} // namespace Setsudan
