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
} // namespace



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
    motion.energy_at_rest = energy_under_loads(from);
  here = Position{
    motion, contact->begin(row, n_ahead(body, row), motion, from.displacement)};
  // What small strain has stored otherwise, as far as the blade has come so.
  if (from.motion)
    here->motion.excess_energy +=
      energy_under_loads(from) - here->equilibrium.energy;
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
NonlinearTravel<dim>::go_on(CutBody<dim> &body, const unsigned int row)
{
  try
    {
      if (const double duration =
            duration_of_rest(this->scene.blade.path, here->motion))
        rest(body, row, duration);
      else
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
    ++motion.n_stops;
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
  book_split(
    released,
    taken,
    here->equilibrium.path->friction_work_to(*after.path)(motion.travel),
    motion);
  here->equilibrium = std::move(after);
  here->is_judged   = false;
  here->trials.clear();
  return this->state(*here, row);
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
