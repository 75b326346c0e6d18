// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/output/output_directory.h>
#include <setsudan/simulation/record/results_writer.h>
#include <setsudan/simulation/state.h>

#include <optional>
#include <vector>

namespace Setsudan
{
/**
 * Where a run stands, so that it can be resumed: what has been cut, the solved
 * state, and the record so far. The mesh is not in it, since the surgeries that
 * lead to it are quickly repeated.
 */
struct Checkpoint
{
  enum class Stage
  {
    /** Nothing has been solved. */
    begun,
    /** A row has been deformed, and waits for being split. */
    row,
    /** A cut has gone through. */
    divided
  };

  Stage stage           = Stage::begun;
  unsigned int n_frames = 0;
  Refinement refinement;
  /** The last event; it names cut and row. */
  Event event;
  WriterState record;

  /** Whether the body has the laws of finite strain. */
  bool finite_strain = false;

  /** Of the state; what is not here follows from it. */
  double load_factor = 0;
  CuttingStress stress;
  bool yields = false;
  /** For each process its part of the displacement. */
  std::vector<std::vector<double>> displacement;
  /** For each process the internal variables of its cells. */
  std::vector<CellData> internal;
};

/** Write a checkpoint as a whole, in place of the last one. Called by all
 * processes; the first one writes. */
void
write_checkpoint(const Checkpoint &checkpoint,
                 const OutputDirectory &directory,
                 const MPI_Comm communicator);

/** Remove the checkpoint of a run that has ended. */
void
remove_checkpoint(const OutputDirectory &directory,
                  const MPI_Comm communicator);

/**
 * The checkpoint in a directory, the same on all processes, which all call
 * this; none, where there is no such file.
 *
 * @throw SceneError for a file that is none.
 */
std::optional<Checkpoint>
read_checkpoint(const OutputDirectory &directory, const MPI_Comm communicator);

/** Put a solved state into a checkpoint. Called by all processes; the first one
 * gets it all. */
template <int dim>
void
store_state(const State<dim> &state,
            const CutBody<dim> &body,
            Checkpoint &checkpoint);

/**
 * The state of a checkpoint on `body`, which has been cut so far.
 *
 * @throw SceneError where it is not of this body.
 */
template <int dim>
State<dim>
restore_state(const Checkpoint &checkpoint, CutBody<dim> &body);
} // namespace Setsudan
