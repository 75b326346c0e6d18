// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/seam/wall_overlap.h>
#include <setsudan/output/tables/event.h>
#include <setsudan/simulation/state.h>

namespace Setsudan
{
/**
 * Fill the columns of a state: energies, residuals, extremes.
 *
 * Forces balance relative to their sizes; or, where they are nothing but
 * round-off since nothing strains the body, to the forces with which it would
 * resist what supports and openings prescribe if the rest of it stayed at rest:
 * those are what its equations were solved for.
 *
 * @return the overlap of the cuts' walls.
 * @throw InvariantError where forces or moments are not in balance.
 */
template <int dim>
WallOverlap<dim>
evaluate_state(const CutBody<dim> &body, const State<dim> &state, Event &event);

/**
 * Assert that letting go of constraints has not raised the potential energy
 * under the new state's forces, apart from the work that the blade's thickness
 * has done in wedging the row open:
 *   E(before) + (forces of the wedge) . (new opening) >= E(after).
 * It follows from `after` being the minimum of E over a larger set. In a body
 * that is not linear the bound on the work does not hold, and pressures may
 * have no potential: both are left out there.
 *
 * @throw InvariantError with the numbers where it does not hold.
 */
template <int dim>
void
check_energy_of_split(const CutBody<dim> &body,
                      const State<dim> &before,
                      const State<dim> &after);
} // namespace Setsudan
