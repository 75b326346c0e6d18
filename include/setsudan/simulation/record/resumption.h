// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/record/checkpoint.h>

#include <optional>

namespace Setsudan
{
/** The earlier run in the output directory of a scene. */
struct EarlierRun
{
  /** It has ended, and there is nothing to go on with. */
  bool finished = false;
  /** Where it stood; none, if nothing had been solved. */
  std::optional<Checkpoint> checkpoint;
};

/**
 * Look for a run to resume. Called by all processes.
 *
 * @throw SceneError where it is a run of another scene or on another number of
 * processes, or where the scene has no checkpoints.
 */
template <int dim>
EarlierRun
find_earlier_run(const Scene<dim> &scene,
                 const Parameters &parameters,
                 const MPI_Comm communicator);

/** Cut a body, without solving, as far as it was at a checkpoint. */
template <int dim>
void
repeat_surgeries(const Checkpoint &checkpoint, CutBody<dim> &body);
} // namespace Setsudan
