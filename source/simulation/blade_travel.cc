// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/yield/cutting_stress.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/simulation/blade_travel.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();

/** The energy that is left for new surface where one stage follows another,
 * over the travel. */
template <int dim>
Quadratic
energy_set_free(const ContactPath<dim> &before, const ContactPath<dim> &after)
{
  Quadratic result      = before.energy();
  const Quadratic rest  = after.energy();
  const Quadratic taken = before.friction_work_to(after);
  for (unsigned int i = 0; i < 3; ++i)
    result.c[i] -= rest.c[i] + taken.c[i];
  return result;
}



/** Move the blade on while the contacts stay as they are. */
template <int dim>
void
move_to(const double travel,
        const double slice,
        const double speed,
        const ContactPath<dim> &path,
        BladeMotion &motion)
{
  const auto force_at = [&](const double p) {
    return path.edge_force()(p) + path.flank_force()(p) +
           slice * path.force_aside()(p);
  };
  motion.work +=
    (force_at(motion.travel) + force_at(travel)) / 2 * (travel - motion.travel);
  const Quadratic unfelt = path.unfelt_force();
  motion.unfelt_work +=
    (unfelt(motion.travel) + unfelt(travel)) / 2 * (travel - motion.travel);
  motion.friction_energy += path.friction_work(motion.travel, travel);
  if (speed > 0)
    motion.time += (travel - motion.travel) / speed;
  motion.travel = travel;
}



/** The potential energy of a body under its loads without the blade's forces.
 */
template <int dim>
double
energy_under_loads(const State<dim> &state)
{
  LA::Vector loads = state.forces;
  loads -= state.blade.nodal_forces;
  return state.strain_energy - loads * state.displacement;
}



/** @throw InvariantError where the blade's work is not the sum of what it has
 * become. */
template <int dim>
void
check_energy(const CutBody<dim> &body, const State<dim> &state)
{
  constexpr double tolerance = 1e-6;
  const BladeMotion &motion  = *state.motion;
  const double stored = energy_under_loads(state) - motion.energy_at_rest;
  const double lost   = motion.work - stored - motion.surface_energy -
                      motion.friction_energy - motion.excess_energy;
  // The loads of a piece that has been dropped are gone.
  if (!body.floating_pieces().empty() ||
      std::abs(lost) <=
        tolerance * (std::abs(motion.work) + std::abs(motion.energy_at_rest)))
    return;
  std::ostringstream message;
  message << "The energy of the blade does not close: of its work of "
          << motion.work << " the body stores " << stored
          << ", new surface takes " << motion.surface_energy << ", friction "
          << motion.friction_energy << " and unstable releases "
          << motion.excess_energy << ", and " << lost
          << " is missing. The solution is not to be trusted.";
  throw InvariantError(message.str());
}
} // namespace


template <int dim>
BladeTravel<dim>::BladeTravel(const Scene<dim> &scene)
  : Drive<dim>(scene)
  , profile(scene.blade.profile)
{
}



template <int dim>
CutContact<dim> &
BladeTravel<dim>::contact(CutBody<dim> &body)
{
  if (!cut_contact || !cut_contact->is_of(body))
    {
      path.reset();
      cut_contact = std::make_unique<CutContact<dim>>(body, profile);
    }
  return *cut_contact;
}



template <int dim>
unsigned int
BladeTravel<dim>::n_looked_ahead(CutBody<dim> &body,
                                 const unsigned int row) const
{
  const unsigned int given = this->scene.division.look_ahead;
  const auto &rows         = body.seam().rows();
  if (given > 0 || row + 1 >= rows.size())
    return std::max(given, 1u);
  // A cut begins with about 3.7 times this length on any mesh.
  const RowArea &opened = body.area_of_row(row);
  const double length =
    requirement(opened.energy, this->scene.blade.sharpness) / opened.area /
    this->scene.material.smallest_youngs_modulus();
  const double row_length = rows[row + 1].depth - rows[row].depth;
  return std::max(2., std::ceil(4 * length / row_length));
}



template <int dim>
std::vector<typename BladeTravel<dim>::Trial>
BladeTravel<dim>::make_trials(CutBody<dim> &body,
                              const unsigned int row,
                              const BladeMotion &motion)
{
  const unsigned int n_left = body.seam().rows().size() - row;
  const unsigned int most   = std::min(n_looked_ahead(body, row), n_left);
  std::vector<Trial> trials;
  double area = 0, required = 0;
  const ContactPath<dim> *neighbour = path.get();
  for (unsigned int n = 1; n <= most; ++n)
    {
      const RowArea &opened = body.area_of_row(row + n - 1);
      area += opened.area;
      required += requirement(opened.energy, this->scene.blade.sharpness);
      trials.push_back({n,
                        area,
                        required,
                        body.length_of_rows(row, n),
                        contact(body).path(row + n, 0, motion, neighbour)});
      neighbour = trials.back().path.get();
    }
  return trials;
}



template <int dim>
double
BladeTravel<dim>::rate_factor(const double length,
                              const BladeMotion &motion) const
{
  const double moved = motion.travel - motion.last_split;
  return this->scene.rate.is_active()
           ? this->scene.rate.factor(length / moved * this->scene.blade.speed)
           : 1.;
}



template <int dim>
std::optional<double>
BladeTravel<dim>::travel_of_split(const Trial &trial,
                                  const BladeMotion &motion,
                                  const double end) const
{
  Quadratic gain = energy_set_free(*path, *trial.path);
  if (!this->scene.rate.is_active())
    {
      gain.c[0] -= trial.required;
      return gain.first_root(motion.travel, end);
    }
  // What is required falls with the time since the last split, from infinity.
  const auto excess = [&](const double p) {
    BladeMotion there = motion;
    there.travel      = p;
    return gain(p) / (trial.required * rate_factor(trial.length, there)) - 1;
  };
  if (excess(motion.travel) >= 0)
    return motion.travel;
  double last = std::min(end, motion.travel + trial.length);
  while (excess(last) < 0 && last < end)
    last = std::min(end, motion.travel + 2 * (last - motion.travel));
  if (!(excess(last) >= 0))
    return {};
  boost::uintmax_t most = 200;
  return boost::math::tools::toms748_solve(
           excess,
           motion.travel,
           last,
           boost::math::tools::eps_tolerance<double>(52),
           most)
    .second;
}



template <int dim>
const typename BladeTravel<dim>::Trial *
BladeTravel<dim>::follow(std::vector<Trial> &trials, BladeMotion &motion)
{
  // More changes of the contact than a row has.
  constexpr unsigned int most = 1000000;
  for (unsigned int n_changes = 0; n_changes < most; ++n_changes)
    {
      double end = path->end();
      for (const auto &trial : trials)
        end = std::min(end, trial.path->end());
      const Trial *first = nullptr;
      double travel      = end;
      for (const auto &trial : trials)
        {
          const auto root = travel_of_split(trial, motion, travel);
          if (root && (!first || *root < travel))
            {
              first  = &trial;
              travel = *root;
            }
        }
      if (!first && end == infinity)
        return nullptr;
      move_to(travel,
              this->scene.blade.sliding.slice,
              this->scene.blade.speed,
              *path,
              motion);
      if (first)
        return first;
      if (path->end() <= travel)
        motion.excess_energy += path->cross_end();
      for (auto &trial : trials)
        if (trial.path->end() <= travel)
          trial.path->cross_end();
    }
  throw SolverError("The contact of the blade does not settle at a travel of " +
                    std::to_string(motion.travel) +
                    ": walls go on opening and closing. Set Blade/Shoulder "
                    "radius larger, or Blade/Friction lower.");
}



template <int dim>
State<dim>
BladeTravel<dim>::solve(CutBody<dim> &body,
                        const unsigned int row,
                        const BladeMotion &motion,
                        const State<dim> &from)
{
  State<dim> state = solve_state(
    body, contact(body).load(*path, row, motion.travel), 1, from.displacement);
  state.motion                 = motion;
  state.motion->edge_force     = path->edge_force()(motion.travel);
  state.motion->flank_force    = path->flank_force()(motion.travel);
  state.motion->friction_force = path->friction_force()(motion.travel);
  state.motion->force_along    = path->force_aside()(motion.travel);
  state.motion->contact_area   = path->contact_area();
  state.motion->shift          = path->shift(motion.travel);
  check_energy(body, state);
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
  if (row == 0)
    motion.travel = motion.last_split = motion.shift = 0;
  CutContact<dim> &of_cut = contact(body);
  if (!path)
    path = of_cut.path(row, n_looked_ahead(body, row), motion, nullptr);
  auto trials             = make_trials(body, row, motion);
  const Trial *const next = follow(trials, motion);
  motion.n_rows_to_split  = next ? next->n_rows : 0;
  State<dim> state        = solve(body, row, motion, from);
  state.yields            = next != nullptr;
  if (!next)
    return state;
  const double released = energy_set_free(*path, *next->path)(motion.travel);
  const double required = next->required * rate_factor(next->length, motion);
  // Behind the last nodes there may be nothing to open.
  if (next->area > 0)
    state.stress = {released / next->area, required / next->area};
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
  CutContact<dim> &of_cut   = contact(body);
  if (!path)
    path = of_cut.path(before, row - before, motion, nullptr);
  auto split = of_cut.path(row, n_looked_ahead(body, row), motion, path.get());
  double required = 0;
  for (unsigned int r = before; r < row; ++r)
    required +=
      requirement(body.area_of_row(r).energy, this->scene.blade.sharpness);
  required *= rate_factor(body.length_of_rows(before, row - before), motion);
  motion.last_split = motion.travel;
  motion.surface_energy += required;
  motion.friction_energy += path->friction_work_to(*split)(motion.travel);
  motion.excess_energy +=
    energy_set_free(*path, *split)(motion.travel) - required;
  motion.n_rows_to_split = 0;
  path                   = std::move(split);
  return solve(body, row, motion, from);
}



template <int dim>
State<dim>
BladeTravel<dim>::finish(CutBody<dim> &body, const State<dim> &from)
{
  State<dim> state = Drive<dim>::finish(body, from);
  state.motion     = from.motion;
  state.motion->work += state.potential_energy - energy_under_loads(from);
  state.motion->edge_force       = state.motion->flank_force =
    state.motion->friction_force = state.motion->force_along =
      state.motion->contact_area = 0;
  path.reset();
  cut_contact.reset();
  return state;
}



template class BladeTravel<2>;
template class BladeTravel<3>;
} // namespace Setsudan
