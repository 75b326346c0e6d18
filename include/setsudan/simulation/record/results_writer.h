// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/timer.h>

#include <setsudan/cut/seam/wall_overlap.h>
#include <setsudan/output/frames/frames.h>
#include <setsudan/output/output_directory.h>
#include <setsudan/output/progress.h>
#include <setsudan/output/tables/statistics.h>
#include <setsudan/output/tables/summary.h>
#include <setsudan/simulation/cut_body.h>
#include <setsudan/simulation/state.h>

#include <string>
#include <utility>
#include <vector>

namespace Setsudan
{
/** How many states are not to be trusted, in all and for each reason. */
struct Doubts
{
  unsigned int n_states = 0;
  /** A strain beyond Material/Linear range. */
  unsigned int strain = 0;
  /** Elements turned inside out. */
  unsigned int jacobian = 0;
  /** Walls of cuts that have moved through each other. */
  unsigned int overlap = 0;
  /** Split rows that the blade's thickness pulls together. */
  unsigned int pull = 0;
  /** Pieces whose friction on the board is more than Coulomb's. */
  unsigned int slide = 0;
  /** Nodes beyond the board. */
  unsigned int passed = 0;
  /** Digits that the solver has lost. */
  unsigned int round_off = 0;
  /** A law that has lost ellipticity. */
  unsigned int ellipticity = 0;
  /** The largest principal strain of states of small strain. */
  double largest_strain = 0;
};

/** The state of a record, apart from the files of its frames. */
struct WriterState
{
  /** Lines of statistics.csv. */
  std::string table;
  Summary summary;
  /** What cut.pvd lists. */
  std::vector<std::pair<double, std::string>> sequence;
  Doubts doubts;
  /** Those up to which the user has been warned in the present cut. */
  Doubts warned;
  /** How far the blade has gone in the cuts before the present one. */
  double earlier_depths = 0;
  /** Cut and depth of the newest frame. */
  std::pair<unsigned int, double> framed_at{0, 0.};
  /** Seconds since the start: when the present cut began, and now. */
  double cut_began = 0;
  double seconds   = 0;
};

/** Keeps the record of a run: the table of events, frames, node tables, the
 * pieces, and what is said on the way. */
template <int dim>
class ResultsWriter
{
public:
  /** @param timer notes how long writing takes; it must live as long.
   * @param earlier whether the record of an earlier run is kept, to be gone
   * on with. */
  ResultsWriter(const Scene<dim> &scene,
                const Parameters &parameters,
                const MPI_Comm communicator,
                dealii::TimerOutput &timer,
                const OutputDirectory::Earlier earlier);

  /** The table is whole however the run ends. */
  ~ResultsWriter();

  /** Write parameters.prm. */
  void
  write_parameters(const Parameters &parameters) const;

  /** Wait until everything is on the disk.
   *
   * @throw SceneError where it could not be written. */
  void
  finish();

  /** Write summary.json, at the end of a run.
   *
   * @throw OutputError where it could not be written. */
  void
  write_summary() const;

  /** The record so far, when it is on the disk; and go on with one. */
  WriterState
  save();
  void
  restore(const WriterState &record);

  /** Name an event of the present state, and add it to the statistics. */
  void
  record(const std::string &name, Event &event);

  /**
   * Write a solved state, as far as the scene asks for it. `is_stage` marks
   * the states that tell the story of a cut in few pictures.
   *
   * @param event the newest of this state.
   */
  void
  write_state(const CutBody<dim> &body,
              const State<dim> &state,
              const Event &event,
              const bool is_stage);

  /** Write the pieces of the body as bodies of their own.
   *
   * @throw InvariantError where volume has been lost. */
  void
  write_pieces(const CutBody<dim> &body, const State<dim> &state);

  /** Count a state that is not to be trusted, and warn of each reason at its
   * first, until warn_anew() is called; of digits that the solver has lost once
   * in a run. What a solve has to say is said. */
  void
  doubt(const CutBody<dim> &body,
        const Event &event,
        const State<dim> &state,
        const WallOverlap<dim> &overlap);

  /** How many states are not to be trusted and why, in words that follow the
   * number of states; nothing where all are. */
  std::string
  describe_doubts() const;
  void
  warn_anew();

  /** Say where the cut stands. */
  void
  show_row(const Event &event, const unsigned int n_rows);

  Progress progress;
  const OutputDirectory directory;

private:
  /** The time of a new frame in the sequence, as Output/Time says; times grow,
   * by very little where the blade stands still. */
  double
  next_time(const Event &event);

  dealii::Vector<double>
  error_squares_of(const CutBody<dim> &body, const State<dim> &state) const;

  void
  write_deck(const CutBody<dim> &body,
             const State<dim> &state,
             const std::string &name) const;

  const Scene<dim> &scene;
  dealii::TimerOutput &timer;
  const bool is_first_process;
  const unsigned int n_processes;
  FrameWriter frames;
  Statistics statistics;
  Summary summary;
  Doubts doubts, warned;
  double earlier_depths = 0;
  std::pair<unsigned int, double> framed_at{0, 0.};
  double cut_began = 0;
};
} // namespace Setsudan
