// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/timer.h>

#include <setsudan/simulation/drive.h>
#include <setsudan/simulation/record/checkpoint_schedule.h>
#include <setsudan/simulation/record/results_writer.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace Setsudan
{
/** A run of a scene: the body deforms under the blade, yields, and is divided
 * row by row (section 2 of Kakefuda et al. 1996). */
template <int dim>
class Simulation
{
public:
  /**
   * @param scene and `parameters`, which it was read from, must live as long.
   * @param timer notes in its sections where the time goes; it must live as
   *   long.
   * @param checkpoint where an earlier run of this scene stood, if it is to be
   *   resumed.
   *
   * @throw SceneError where the output directory cannot be written.
   */
  Simulation(const Scene<dim> &scene,
             const Parameters &parameters,
             const MPI_Comm communicator,
             dealii::TimerOutput &timer,
             const std::optional<Checkpoint> &checkpoint = {});

  /** @throw SolverError, InvariantError, CutError or OutputError where the run
   * cannot go on, and RunInterrupted. */
  void
  run();

private:
  /** Deform the body, and make its cuts. */
  void
  make_cuts();

  /** Make one cut; the answer is whether it went through. */
  bool
  make_cut(const unsigned int cut);

  /** Split the row on which the blade rests, and all behind it. */
  bool
  make_cut_from(const unsigned int first_row);

  /** Go on where a checkpoint was made, to the end of its cut; the answer is
   * whether it went through. */
  bool
  resume();

  /** Make a checkpoint of what has been solved and recorded, if it is time for
   * one, and stop there if that is wanted from outside.
   *
   * @throw RunInterrupted if so. */
  void
  checkpoint_if_due(const Checkpoint::Stage stage);

  void
  rest();

  /** Lay the body on its board. */
  void
  lie();

  void
  deform_only();

  /** Let loads and supports act for the times of the scene, before the blade
   * comes. */
  void
  pass_time();

  /** Take a state at a later time; the answer is whether its error allows that.
   *
   * @param error that is estimated for it, if any is. */
  bool
  try_step(const double begin, const double end, std::optional<double> &error);

  /** How long the next step is to be.
   *
   * @param step the last one.
   * @param longest that may be.
   * @param error of the last one, if it has been estimated. */
  double
  next_step(const double step,
            const double longest,
            const std::optional<double> &error) const;

  /** The body under its loads at a later time. */
  State<dim>
  state_after(const double begin, const double end);

  /** Note what time it is. */
  void
  set_time(const double time);

  /** Let the time pass in which the front of a cut under given forces goes to a
   * row. */
  void
  move_front(const unsigned int row);

  /** Whether there is anything to cut. */
  bool
  begin_cut(const unsigned int cut);

  void
  deform(const unsigned int row);

  bool
  row_yields(const unsigned int row);

  void
  arrest();

  /** Duplicate the nodes of the cut. */
  void
  split_nodes();

  /** Split the rows that are open before the blade comes; the first row that is
   * not. */
  unsigned int
  open_notch();

  void
  release_row(const unsigned int row);

  /** Take the state in which a blade that travels stands where it was, with the
   * front on this row. */
  void
  settle(const unsigned int row);

  void
  finish_cut();

  /** Name the pieces that float now, besides those `known` before. */
  void
  say_what_is_loose(const std::vector<FloatingPiece> &known);

  /** The state under this part of the loads, from the present one on. */
  State<dim>
  solve(const BladeLoad<dim> &blade, const double load_factor);

  /** Take a solved state, and check what must hold from the last to it.
   *
   * @param again solves for the state with the body as it is then, where it
   *   takes finite strain for this state. */
  void
  accept(State<dim> &&new_state, const std::function<State<dim>()> &again);

  /** Solve with the laws of finite strain from now on. */
  void
  take_finite_strain();

  const Scene<dim> &scene;
  dealii::TimerOutput &timer;
  const std::optional<Checkpoint> checkpoint;
  ResultsWriter<dim> results;
  CheckpointSchedule checkpoints;
  CutBody<dim> body;
  std::unique_ptr<Drive<dim>> drive;
  State<dim> state;
  Event event;
  unsigned int n_frames = 1;
};
} // namespace Setsudan
