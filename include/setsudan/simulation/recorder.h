#pragma once

#include <setsudan/output/frames.h>
#include <setsudan/output/output_directory.h>
#include <setsudan/output/progress.h>
#include <setsudan/output/statistics.h>
#include <setsudan/simulation/cut_body.h>
#include <setsudan/simulation/state.h>

#include <string>
#include <utility>
#include <vector>

namespace Setsudan
{
/** What a record has come to, apart from the files of its frames. */
struct Record
{
  /** Lines of statistics.csv. */
  std::string table;
  /** What cut.pvd lists. */
  std::vector<std::pair<double, std::string>> sequence;
  bool warned_of_round_off = false;
  bool warned_of_strain    = false;
  bool warned_of_jacobian  = false;
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
class Recorder
{
public:
  /** @param earlier whether the record of an earlier run is kept, to be gone
   * on with. */
  Recorder(const Scene<dim> &scene,
           const Parameters &parameters,
           const MPI_Comm communicator,
           const OutputDirectory::Earlier earlier);

  /** The table is whole however the run ends. */
  ~Recorder();

  /** Write parameters.prm. */
  void
  write_parameters(const Parameters &parameters) const;

  /** Wait until everything is on the disk.
   *
   * @throw SceneError where it could not be written. */
  void
  finish();

  /** The record so far, when it is on the disk; and go on with one. */
  Record
  save();
  void
  restore(const Record &record);

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
              const BladeLoad<dim> &blade,
              const Event &event,
              const bool is_stage);

  /** Write the pieces of the body as bodies of their own.
   *
   * @throw std::runtime_error where volume has been lost. */
  void
  write_pieces(const CutBody<dim> &body, const State<dim> &state);

  /** Warn where a linear solution has left its range: once each, until
   * warn_anew() is called. */
  void
  warn_of_range(const Event &event);

  /** Warn of what a solve has to say, and, once, of digits that it has lost. */
  void
  warn_of_solve(const State<dim> &state);

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
  const bool is_first_process;
  FrameWriter frames;
  Statistics statistics;
  bool warned_of_round_off = false;
  bool warned_of_strain    = false;
  bool warned_of_jacobian  = false;
  double earlier_depths    = 0;
  std::pair<unsigned int, double> framed_at{0, 0.};
  double cut_began = 0;
};
} // namespace Setsudan
