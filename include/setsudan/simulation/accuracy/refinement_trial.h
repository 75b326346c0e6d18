// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/accuracy/state_error.h>
#include <setsudan/simulation/cut_body.h>

#include <optional>
#include <vector>

namespace Setsudan
{
/** The record of a trial for the next one. */
struct TrialRecord
{
  /** The depth of the row in the middle. */
  double middle = 0;
  /** The scene's quantity in each of the states. */
  std::vector<double> values;
};

/**
 * The error on a body that is refined in one way, in states that stand for a
 * whole cut: with the blade on the first row, or on the row in the middle, all
 * rows before it split, or both. What decides is often the second, since the
 * stress grows without bound towards the front of a cut.
 *
 * The error is the estimated one (see estimate_error_of_state()), or, where the
 * quantity has begun to converge from trial to trial, what is left of it by
 * extrapolation, if that is less: the estimate is too large where a singular
 * stress is averaged.
 *
 * @throw what solving these states throws.
 */
template <int dim>
class RefinementTrial
{
public:
  /** @param earlier the trials on coarser meshes, in order; the row in the
   * middle is that of the first of them. */
  RefinementTrial(const Scene<dim> &scene,
                  const Refinement &refinement,
                  const std::vector<TrialRecord> &earlier,
                  const MPI_Comm communicator);

  /** Of the scene's quantity, in the state where it is larger. */
  double
  relative_error() const;

  unsigned int
  n_cells() const;

  const TrialRecord &
  record() const;

  /** The cells that hold half of the error in any state which misses the
   * target, as far as the scene lets them be refined; the same on all
   * processes, ascending. For the cutting stress, a cell's error counts the
   * less the farther the front is: what a pair of forces does to the stress at
   * a distance r falls as 1 / r^dim (Kelvin's solution). */
  const std::vector<CellPath> &
  marked() const;

private:
  /** Solve with the blade on a row, or without one. */
  void
  add_state(const std::optional<unsigned int> &row);

  /** The error of the newest value, by the estimate or by extrapolation. */
  double
  error_of_last(const double estimate) const;

  /** Add the cells that hold half of an error. */
  void
  mark(const StateError &error, const std::optional<unsigned int> &row);

  /** What each cell's error counts by, by its active index. */
  dealii::Vector<double>
  weights(const std::optional<unsigned int> &row) const;

  /** The row in the middle of the cut. */
  unsigned int
  middle_row() const;

  /** Split the rows before one.
   *
   * @return whether that can be done, and leaves something of this row. */
  bool
  open_up_to(const unsigned int row);

  const Scene<dim> &scene;
  const std::vector<TrialRecord> &earlier;
  CutBody<dim> body;
  TrialRecord of_this;
  double worst_error = 0;
  std::vector<CellPath> cells;
};
} // namespace Setsudan
