// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/parameters/exceptions.h>
#include <setsudan/simulation/interruption.h>
#include <setsudan/simulation/record/resumption.h>
#include <setsudan/simulation/simulation.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
bool
Simulation<dim>::resume()
{
  if (checkpoint->finite_strain && !scene.material.finite_strain)
    take_finite_strain();
  repeat_surgeries(*checkpoint, body);
  state = restore_state(*checkpoint, body);
  event = checkpoint->event;
  // Where a blade that travels is.
  state.motion = event.motion;
  n_frames     = checkpoint->n_frames;
  results.restore(checkpoint->record);
  const bool divided = checkpoint->stage == Checkpoint::Stage::divided;
  results.progress.info(
    "Resumed behind " +
    (divided ? "" : "row " + std::to_string(event.row + 1) + " of ") + "cut " +
    std::to_string(event.cut) + ".");
  return divided || make_cut_from(event.row);
}



template <int dim>
void
Simulation<dim>::checkpoint_if_due(const Checkpoint::Stage stage)
{
  const bool stops = interrupted(body.communicator());
  if (checkpoints.keeps() && (stops || checkpoints.is_due()))
    {
      Checkpoint reached;
      reached.stage      = stage;
      reached.n_frames   = n_frames;
      reached.event      = event;
      reached.refinement = body.refinement();
      reached.record     = results.save();
      const TimerOutput::Scope section(timer, "checkpoint");
      store_state(state, body, reached);
      checkpoints.make(reached);
    }
  if (stops)
    throw RunInterrupted(
      "The run was interrupted behind row " + std::to_string(event.row + 1) +
      " of cut " + std::to_string(event.cut) +
      (checkpoints.keeps() ? "; with --resume it goes on from there."
                           : "; Output/Checkpoint = none leaves nothing to "
                             "resume from."));
}



#define INSTANTIATE(dim)                   \
  template bool Simulation<dim>::resume(); \
  template void Simulation<dim>::checkpoint_if_due(const Checkpoint::Stage);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
