// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mechanics/assumed_state.h>
#include <setsudan/simulation/nonlinear_travel.h>

#include <algorithm>
#include <cmath>
#include <limits>

// The steps of the blade, and where on the way rows split.

namespace Setsudan
{
namespace
{
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
typename NonlinearTravel<dim>::Position
NonlinearTravel<dim>::move(CutBody<dim> &body,
                           const unsigned int row,
                           const Position &from,
                           const double travel,
                           const double time) const
{
  Position next;
  next.motion        = from.motion;
  next.motion.travel = travel;
  next.motion.time   = time;
  body.let_time_pass(time - here->motion.time);
  next.equilibrium =
    contact->reach(row, n_ahead(body, row), next.motion, from.equilibrium);
  const auto &before = *from.equilibrium.path, &after = *next.equilibrium.path;
  const double begin = from.motion.travel, way = travel - begin;
  const ContactResultants first = before.resultants(),
                          last  = after.resultants();
  // By values and slopes at both ends; where contacts change at the beginning,
  // its slope is not that of the way.
  const bool changes = std::abs(before.end() - begin) < 1e-6 * std::abs(way);
  // Slopes are those without time, and without what flows on the way.
  const bool remembers = !body.model().internal.empty();
  const auto work_of   = [&](Quadratic ContactResultants::*part) {
    const double at_begin = (first.*part)(begin), at_end = (last.*part)(travel);
    const double slope_at_begin = (first.*part).c[1],
                 slope_at_end   = (last.*part).c[1];
    if (remembers)
      return (at_begin + at_end) / 2 * way;
    return changes
               ? (at_begin + 2 * at_end) / 3 * way - slope_at_end * way * way / 6
               : (at_begin + at_end) / 2 * way +
                 (slope_at_begin - slope_at_end) * way * way / 12;
  };
  next.motion.work +=
    work_of(&ContactResultants::edge) + work_of(&ContactResultants::flanks) +
    this->scene.blade.sliding.slice * work_of(&ContactResultants::aside);
  next.motion.unfelt_work += work_of(&ContactResultants::unfelt);
  next.motion.friction_energy += before.friction_work_to(after, begin, travel);
  return next;
}



template <int dim>
typename NonlinearTravel<dim>::Position
NonlinearTravel<dim>::move(CutBody<dim> &body,
                           const unsigned int row,
                           const Position &from,
                           const double travel) const
{
  const double speed = this->scene.blade.path.speed_to(from.motion.n_stops);
  const double way   = std::abs(travel - from.motion.travel);
  return move(
    body, row, from, travel, from.motion.time + (speed > 0 ? way / speed : 0));
}



template <int dim>
void
NonlinearTravel<dim>::stay(CutBody<dim> &body, Position &&position)
{
  body.let_time_pass(position.motion.time - here->motion.time);
  body.accept(position.equilibrium.displacement);
  here = std::move(position);
}



template <int dim>
void
NonlinearTravel<dim>::rest(CutBody<dim> &body,
                           const unsigned int row,
                           const double duration)
{
  // Of the force, what may change in a step.
  constexpr double most = 0.05, smallest = 1. / 1024;
  const double travel = here->motion.travel, begin = here->motion.time,
               end = begin + duration;
  const auto force = [&](const Position &position) {
    const auto all = position.equilibrium.path->resultants();
    return all.edge(travel) + all.flanks(travel);
  };
  for (double step = duration; here->motion.time < end;)
    {
      // Half of a step is left where that is round-off.
      const double next_time = here->motion.time + step > end - step / 2
                                 ? end
                                 : here->motion.time + step;
      Position next          = move(body, row, *here, travel, next_time);
      const double before = force(*here), after = force(next);
      const double change = std::abs(after - before);
      const double scale  = std::max(std::abs(before), std::abs(after));
      if (body.model().materials.is_viscous() && change > most * scale &&
          step > smallest * duration)
        {
          step /= 2;
          continue;
        }
      stay(body, std::move(next));
      if (change < most / 4 * scale)
        step *= 2;
    }
}



template <int dim>
void
NonlinearTravel<dim>::judge(CutBody<dim> &body,
                            const unsigned int row,
                            Position &position) const
{
  position.trials.clear();
  position.is_judged = true;
  body.let_time_pass(position.motion.time - here->motion.time);
  const AssumedState<dim> assumed(body.model(),
                                  position.equilibrium.displacement);
  if (!this->scene.yield.compares_energies())
    {
      State<dim> state = this->state(position, row);
      check_yield(body, row, state);
      position.stress = state.stress;
      position.stress.required *= search->rate_factor(
        body.length_of_rows(row, 1), position.motion, position.motion.travel);
      return;
    }
  double area = 0, largest = -std::numeric_limits<double>::infinity();
  const unsigned int most = n_ahead(body, row);
  for (unsigned int n = 1; n <= most; ++n)
    {
      const double released = try_split(body, row, n, position);
      area += body.area_of_row(row + n - 1).area;
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
double
NonlinearTravel<dim>::try_split(CutBody<dim> &body,
                                const unsigned int row,
                                const unsigned int n,
                                Position &position) const
{
  const BladeMotion &motion = position.motion;
  const double speed        = this->scene.blade.path.speed_to(motion.n_stops);
  const Equilibrium &neighbour =
    position.trials.empty() ? position.equilibrium : position.trials.back();
  if (speed == 0 || !body.model().materials.is_viscous())
    {
      Equilibrium released = contact->reach(row + n, 0, motion, neighbour);
      position.trials.push_back(std::move(released));
      return energy_set_free(position, position.trials.back());
    }
  // The front takes time to pass, in which the body goes on to relax: one that
  // is slow finds the stiffness that lasts. Both states are of then.
  body.let_time_pass(body.length_of_rows(row, n) / speed);
  const Equilibrium tied =
    contact->reach(row, n_ahead(body, row), motion, position.equilibrium);
  const Equilibrium released = contact->reach(row + n, 0, motion, tied);
  return tied.potential() - released.potential() -
         tied.path->friction_work_to(*released.path)(motion.travel);
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
  return std::max(here->motion.work, body.area_of_row(row).energy);
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
  if (goal != here->motion.travel)
    here->motion.excess_energy +=
      here->equilibrium.path->head(pushes ? 1 : -1, here->motion.travel);
  if (pushes)
    judge(body, row, *here);
  while (here->motion.travel != goal && !here->yields())
    {
      Position next = step(body, row, length, goal);
      if (pushes)
        {
          judge(body, row, next);
          if (next.yields())
            next = locate(body, row, *here, std::move(next));
          else
            length = next_step(*here, next, longest);
        }
      stay(body, std::move(next));
    }
}



#define INSTANTIATE(dim)                                                       \
  template double NonlinearTravel<dim>::Position::excess() const;              \
  template void NonlinearTravel<dim>::rest(                                    \
    CutBody<dim> &, const unsigned int, const double);                         \
  template void NonlinearTravel<dim>::judge(                                   \
    CutBody<dim> &, const unsigned int, Position &) const;                     \
  template double NonlinearTravel<dim>::try_split(                             \
    CutBody<dim> &, const unsigned int, const unsigned int, Position &) const; \
  template double NonlinearTravel<dim>::energy_of_row(                         \
    CutBody<dim> &, const unsigned int) const;                                 \
  template void NonlinearTravel<dim>::follow(                                  \
    CutBody<dim> &, const unsigned int, const double);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
