// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/stress/error_estimate.h>
#include <setsudan/simulation/cut_body.h>
#include <setsudan/simulation/state.h>

#include <optional>

namespace Setsudan
{
/** The estimated error of a solved state. */
struct StateError
{
  ErrorEstimate energy;
  /** Of the cutting stress, relative. */
  double cutting_stress = 0;

  /** That of the quantity which the scene's target is for. */
  double
  relative(const AccuracyParameters::Quantity quantity) const;
};

/**
 * Estimate the error of a state. That of the cutting stress is its difference
 * to what the criterion makes of the recovered stress; with the criterion
 * `energy release` it is taken to be that of the energy.
 *
 * @param row the row under the blade, or nothing.
 */
template <int dim>
StateError
estimate_error_of_state(const CutBody<dim> &body,
                        const std::optional<unsigned int> &row,
                        const State<dim> &state);
} // namespace Setsudan
