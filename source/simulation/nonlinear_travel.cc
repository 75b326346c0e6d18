// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/parameters/exceptions.h>
#include <setsudan/parameters/lists.h>
#include <setsudan/simulation/checks.h>
#include <setsudan/simulation/nonlinear_travel.h>
#include <setsudan/simulation/travel.h>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
namespace
{
/** Work is summed from the forces before and after each step: the energy closes
 * as far as these are smooth between. */
constexpr double tolerance_of_energy = 0.02;

/** Of the blade, between two equilibria. */
template <int dim>
double
longest_step(const CutBody<dim> &body)
{
  const double given = body.scene().blade.advance;
  return given > 0 ? given : shortest_row(body) / 2;
}

/** Of a ratio that may be less than 0. */
double
root_of(const double ratio)
{
  return std::sqrt(std::max(0., ratio));
}
} // namespace


template <int dim>
double
NonlinearTravel<dim>::Position::excess() const
{
  const auto &[reached, required] = stress;
  return required > 0 ? reached / required - 1 : reached;
}



template <int dim>
NonlinearTravel<dim>::NonlinearTravel(const Scene<dim> &scene)
  : Drive<dim>(scene)
  , search(SplitSearch<dim>::make(scene))
{
}



template <int dim>
unsigned int
NonlinearTravel<dim>::n_ahead(CutBody<dim> &body, const unsigned int row) const
{
  const unsigned int n_left = body.seam().rows().size() - row;
  return std::min(search->n_looked_ahead(body, row), n_left);
}



template <int dim>
void
NonlinearTravel<dim>::begin(CutBody<dim> &body,
                            const unsigned int row,
                            const State<dim> &from)
{
  if (contact && contact->is_of_present_body() && here &&
      here->equilibrium.n_split == row)
    return;
  contact = std::make_unique<NonlinearContact<dim>>(
    body, this->scene.blade.profile, from.displacement);
  BladeMotion motion = from.motion.value_or(BladeMotion());
  if (!from.motion)
    motion.energy_at_rest = from.potential_energy;
  here = Position{
    motion, contact->begin(row, n_ahead(body, row), motion, from.displacement)};
}



template <int dim>
typename NonlinearTravel<dim>::Position
NonlinearTravel<dim>::move(CutBody<dim> &body,
                           const unsigned int row,
                           const Position &from,
                           const double travel) const
{
  Position next;
  next.motion        = from.motion;
  next.motion.travel = travel;
  next.equilibrium =
    contact->reach(row, n_ahead(body, row), next.motion, from.equilibrium);
  const auto &before = *from.equilibrium.path, &after = *next.equilibrium.path;
  const double begin = from.motion.travel, way = travel - begin;
  const ContactResultants first = before.resultants(),
                          last  = after.resultants();
  // By values and slopes at both ends.
  const auto work_of = [&](Quadratic ContactResultants::*part) {
    const double slopes = (first.*part).c[1] - (last.*part).c[1];
    return ((first.*part)(begin) + (last.*part)(travel)) / 2 * way +
           slopes * way * way / 12;
  };
  next.motion.work +=
    work_of(&ContactResultants::edge) + work_of(&ContactResultants::flanks) +
    this->scene.blade.sliding.slice * work_of(&ContactResultants::aside);
  next.motion.unfelt_work += work_of(&ContactResultants::unfelt);
  next.motion.friction_energy += before.friction_work_to(after, begin, travel);
  const double speed = this->scene.blade.path.speed_to(next.motion.n_stops);
  if (speed > 0)
    next.motion.time += std::abs(way) / speed;
  return next;
}



template <int dim>
double
NonlinearTravel<dim>::energy_set_free(const Position &position,
                                      const Equilibrium &after) const
{
  const Equilibrium &before = position.equilibrium;
  return before.energy - after.energy -
         before.path->friction_work_to(*after.path)(position.motion.travel);
}



template <int dim>
void
NonlinearTravel<dim>::judge(CutBody<dim> &body,
                            const unsigned int row,
                            Position &position) const
{
  position.trials.clear();
  position.is_judged = true;
  if (!this->scene.yield.compares_energies())
    {
      State<dim> state = this->state(position, row);
      check_yield(body, row, state);
      position.stress = state.stress;
      position.stress.required *= search->rate_factor(
        body.length_of_rows(row, 1), position.motion, position.motion.travel);
      return;
    }
  double area = 0, largest = -1;
  const Equilibrium *neighbour = &position.equilibrium;
  const unsigned int most      = n_ahead(body, row);
  position.trials.reserve(most);
  for (unsigned int n = 1; n <= most; ++n)
    {
      position.trials.push_back(
        contact->reach(row + n, 0, position.motion, *neighbour));
      neighbour = &position.trials.back();
      area += body.area_of_row(row + n - 1).area;
      const double released = energy_set_free(position, *neighbour);
      const double required =
        search->surface_energy(body, row, n, position.motion, released);
      // Behind the last nodes there may be nothing to open.
      if (area > 0 && released > largest * required)
        {
          largest         = released / required;
          position.n_rows = n;
          position.stress = {released / area, required / area};
        }
    }
}



template <int dim>
typename NonlinearTravel<dim>::Position
NonlinearTravel<dim>::locate(CutBody<dim> &body,
                             const unsigned int row,
                             Position before,
                             Position after) const
{
  const double tolerance      = this->scene.blade.advance_tolerance;
  constexpr unsigned int most = 50;
  for (unsigned int i = 0; after.excess() > tolerance && i < most; ++i)
    {
      // A little beyond where a straight line meets what is required; in the
      // middle where that does not come nearer.
      const double begin = before.motion.travel, end = after.motion.travel;
      const double low =
        root_of(1 + before.excess()) - root_of(1 + tolerance / 2);
      const double high =
        root_of(1 + after.excess()) - root_of(1 + tolerance / 2);
      const double part = i % 4 == 3 ? 0.5 : low / (low - high);
      Position tried    = move(body, row, before, begin + part * (end - begin));
      judge(body, row, tried);
      (tried.yields() ? after : before) = std::move(tried);
    }
  return after;
}



template <int dim>
double
NonlinearTravel<dim>::next_step(const Position &before,
                                const Position &now,
                                const double longest) const
{
  // Energies go with the square of the travel: a little beyond where they will
  // be enough.
  const double reached = root_of(1 + now.excess());
  const double slope   = (reached - root_of(1 + before.excess())) /
                       (now.motion.travel - before.motion.travel);
  return slope > 0 ? std::min(longest, 1.02 * (1 - reached) / slope) : longest;
}



template <int dim>
double
NonlinearTravel<dim>::energy_of_row(CutBody<dim> &body,
                                    const unsigned int row) const
{
  const BladeMotion &motion = here->motion;
  return std::max(motion.work,
                  search->surface_energy(body, row, 1, motion, 0.));
}



template <int dim>
typename NonlinearTravel<dim>::Position
NonlinearTravel<dim>::step(CutBody<dim> &body,
                           const unsigned int row,
                           const double longest,
                           const double goal) const
{
  // Of the work of a step, what may be missing. Friction is summed from
  // pressures, which are less smooth than forces.
  const double tolerance    = this->scene.blade.sliding.rubs() ? 2e-2 : 5e-3;
  constexpr double smallest = 1. / 64;
  const double of_row       = energy_of_row(body, row);
  const double travel       = here->motion.travel;
  for (double length = longest;; length /= 2)
    {
      Position next     = move(body,
                           row,
                           *here,
                           goal >= travel ? std::min(travel + length, goal)
                                              : std::max(travel - length, goal));
      const double work = next.motion.work - here->motion.work;
      const double lost =
        work - (next.motion.friction_energy - here->motion.friction_energy) -
        (next.equilibrium.energy - here->equilibrium.energy);
      if (std::abs(lost) <= tolerance * (std::abs(work) + of_row / 10))
        return next;
      if (length <= smallest * longest)
        {
          // It has sprung to another place.
          next.motion.excess_energy += lost;
          return next;
        }
    }
}



template <int dim>
void
NonlinearTravel<dim>::follow(CutBody<dim> &body,
                             const unsigned int row,
                             const double goal)
{
  const double longest = longest_step(body);
  // What is split closes while the blade is withdrawn, and no more splits.
  const bool pushes = goal >= here->motion.travel;
  double length     = longest;
  if (pushes)
    judge(body, row, *here);
  while (here->motion.travel != goal && !here->yields())
    {
      Position next = step(body, row, length, goal);
      if (pushes)
        {
          judge(body, row, next);
          if (next.yields())
            next = locate(body, row, std::move(*here), std::move(next));
          else
            length = next_step(*here, next, longest);
        }
      here = std::move(next);
    }
}



template <int dim>
void
NonlinearTravel<dim>::go_on(CutBody<dim> &body, const unsigned int row)
{
  try
    {
      follow(body, row, goal_of_travel(body, here->motion));
    }
  catch (const NoEquilibriumError &error)
    {
      std::string message =
        "Beyond a travel of " +
        short_text(std::round(1000 * here->motion.travel) / 1000) + ": " +
        error.what();
      if (row == 0)
        message += " An edge has no width, and presses a node of a flat face "
                   "through itself: let the cut begin with Cut/Notch.";
      throw NoEquilibriumError(message);
    }
}



template <int dim>
State<dim>
NonlinearTravel<dim>::state(const Position &position,
                            const unsigned int row) const
{
  State<dim> state = contact->state(position.equilibrium, row);
  state.motion     = position.motion;
  set_contact(*position.equilibrium.path, *state.motion);
  return state;
}



template <int dim>
State<dim>
NonlinearTravel<dim>::advance(CutBody<dim> &body,
                              const unsigned int row,
                              const State<dim> &from)
{
  begin(body, row, from);
  const auto &stops = this->scene.blade.path.stops;
  go_on(body, row);
  BladeMotion &motion    = here->motion;
  const bool yields      = here->yields();
  motion.n_rows_to_split = yields ? here->n_rows : 0;
  if (!yields && motion.n_stops < stops.size())
    reach_stop(this->scene.blade.path, motion);
  State<dim> state = this->state(*here, row);
  state.stress     = here->stress;
  state.yields     = yields;
  check_energy_of_blade(
    body, state, tolerance_of_energy, energy_of_row(body, row));
  return state;
}



template <int dim>
std::optional<State<dim>>
NonlinearTravel<dim>::settle(CutBody<dim> &body,
                             const unsigned int row,
                             const State<dim> &from)
{
  const unsigned int n = from.motion->n_rows_to_split, before = row - n;
  begin(body, before, from);
  Equilibrium after =
    n <= here->trials.size()
      ? std::move(here->trials[n - 1])
      : contact->reach(row, 0, here->motion, here->equilibrium);
  BladeMotion &motion   = here->motion;
  const double released = energy_set_free(*here, after);
  const double taken =
    search->surface_energy(body, before, n, motion, released);
  motion.time_of_split = motion.time;
  motion.surface_energy += taken;
  motion.friction_energy +=
    here->equilibrium.path->friction_work_to(*after.path)(motion.travel);
  motion.excess_energy += released - taken;
  motion.n_rows_to_split = 0;
  here->equilibrium      = std::move(after);
  here->is_judged        = false;
  here->trials.clear();
  return this->state(*here, row);
}



template <int dim>
bool
NonlinearTravel<dim>::moves_on(const State<dim> &state) const
{
  return state.motion->n_stops < this->scene.blade.path.stops.size();
}



template <int dim>
State<dim>
NonlinearTravel<dim>::finish(CutBody<dim> &body, const State<dim> &from)
{
  const unsigned int n_rows = body.seam().rows().size();
  begin(body, n_rows, from);
  here->equilibrium = contact->without_blade(here->motion, here->equilibrium);
  State<dim> state  = contact->state(here->equilibrium, n_rows);
  give_back(from, state);
  here.reset();
  contact.reset();
  return state;
}



template class NonlinearTravel<2>;
template class NonlinearTravel<3>;
} // namespace Setsudan
