#pragma once

#include <setsudan/output/statistics.h>
#include <setsudan/simulation/state.h>

namespace Setsudan
{
/**
 * Fill the columns of a state: energies, residuals, extremes.
 *
 * @throw SolverError where forces or moments are not in balance.
 */
template <int dim>
void
describe_state(const Scene<dim> &scene,
               const CutBody<dim> &body,
               const BladeLoad<dim> &blade,
               const State<dim> &state,
               Event &event);

/**
 * Assert that letting go of constraints has not raised the potential energy
 * under the new state's forces, apart from the work that the blade's thickness
 * has done in wedging the row open:
 *   E(before) + (forces of the wedge) . (new opening) >= E(after).
 * It follows from `after` being the minimum of E over a larger set.
 *
 * @throw SolverError with the numbers where it does not hold.
 */
template <int dim>
void
check_energy_of_split(const CutBody<dim> &body,
                      const State<dim> &before,
                      const State<dim> &after);
} // namespace Setsudan
