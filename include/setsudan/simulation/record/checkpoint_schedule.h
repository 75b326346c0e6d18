// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/output/progress.h>
#include <setsudan/simulation/record/checkpoint.h>

namespace Setsudan
{
/** Makes the checkpoints of a run as often as its scene asks for. Called by all
 * processes. */
class CheckpointSchedule
{
public:
  /** @param directory and `progress`, the run's clock, must live as long. */
  CheckpointSchedule(const OutputParameters::Checkpoint when,
                     const OutputDirectory &directory,
                     const Progress &progress,
                     const MPI_Comm communicator);

  /** Whether the scene asks for any. */
  bool
  keeps() const;

  /** Whether it is time for one, the same on all processes. */
  bool
  is_due() const;

  void
  make(const Checkpoint &checkpoint);

  /** The run has ended: there is nothing to resume. */
  void
  finish() const;

private:
  const OutputParameters::Checkpoint when;
  const OutputDirectory &directory;
  const Progress &progress;
  const MPI_Comm communicator;
  /** When the last one was made, and how long that took [s]. */
  double last = 0;
  double took = 0;
};
} // namespace Setsudan
