// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/contact/contact_path.h>
#include <setsudan/simulation/state.h>

namespace Setsudan
{
/** The next stop on the way of a blade that travels, or where it cannot go on;
 * infinite where nothing stops it. */
template <int dim>
double
goal_of_travel(const CutBody<dim> &body, const BladeMotion &motion);

/** How long the blade rests where it is before it goes on; 0 if it does not. */
double
duration_of_rest(const BladePath &way, const BladeMotion &motion);

/** Take the forces of a contact where the blade is. */
template <int dim>
void
set_contact(const ContactPath<dim> &path, BladeMotion &motion);

/** Let rows split where the blade is.
 *
 * @param released what they set free besides friction.
 * @param taken by the new surface. */
void
book_split(const double released,
           const double taken,
           const double friction,
           BladeMotion &motion);

/** Let the blade be gone, to which the walls give back what they had stored.
 *
 * @param from the state before. */
template <int dim>
void
give_back(const State<dim> &from, State<dim> &state);

/** @param tolerance relative to the blade's work.
 * @param scale an energy beside which less is small, too.
 * @throw InvariantError where the blade's work is not the sum of what it has
 * become. */
template <int dim>
void
check_energy_of_blade(const CutBody<dim> &body,
                      const State<dim> &state,
                      const double tolerance,
                      const double scale = 0);
} // namespace Setsudan
