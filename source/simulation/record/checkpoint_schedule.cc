// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/simulation/record/checkpoint_schedule.h>

namespace Setsudan
{
using When = OutputParameters::Checkpoint;

CheckpointSchedule::CheckpointSchedule(const When when,
                                       const OutputDirectory &directory,
                                       const Progress &progress,
                                       const MPI_Comm communicator)
  : when(when)
  , directory(directory)
  , progress(progress)
  , communicator(communicator)
{
}



bool
CheckpointSchedule::keeps() const
{
  return when != When::none;
}



bool
CheckpointSchedule::is_due() const
{
  if (when != When::automatic)
    return keeps();
  // A fiftieth of the time goes into checkpoints.
  const bool due = progress.seconds() - last >= 50 * took;
  return dealii::Utilities::MPI::broadcast(communicator, due);
}



void
CheckpointSchedule::make(const Checkpoint &checkpoint)
{
  if (!keeps())
    return;
  const double begin = progress.seconds();
  write_checkpoint(checkpoint, directory, communicator);
  last = progress.seconds();
  took = last - begin;
}



void
CheckpointSchedule::finish() const
{
  if (keeps())
    remove_checkpoint(directory, communicator);
}
} // namespace Setsudan
