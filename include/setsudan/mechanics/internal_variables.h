// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/array_view.h>

#include <setsudan/material/material_parameters.h>
#include <setsudan/space/discretization.h>
#include <setsudan/space/transfer.h>

#include <vector>

namespace Setsudan
{
/** The internal variables of this process's cells at their quadrature points,
 * of the last accepted state and of the one that is being solved for. No memory
 * where no law has any. */
template <int dim>
class InternalVariables
{
public:
  /** Those of the body at rest.
   *
   * @param discretization and materials must live as long. */
  InternalVariables(const Discretization<dim> &discretization,
                    const MaterialParameters<dim> &materials,
                    const unsigned int n_points);

  /** Whether no law has any. */
  bool
  empty() const;

  /** What a law is evaluated with.
   *
   * @param cell its active index. */
  History
  history(const unsigned int cell, const unsigned int point);

  /** What a law has set. */
  dealii::ArrayView<const double>
  present(const unsigned int cell, const unsigned int point) const;

  /** Let the states that are solved for be so much later than the last accepted
   * one [time]. */
  void
  set_time_step(const double duration)
  {
    step = duration;
  }

  double
  time_step() const
  {
    return step;
  }

  /** Let the state that was solved for be the last accepted one; no time passes
   * behind it until a step is set. */
  void
  accept();

  /** The last accepted state, and how much time passes behind it. */
  struct Snapshot
  {
    std::vector<double> accepted;
    double time_step = 0;
  };

  Snapshot
  save() const
  {
    return {accepted, step};
  }

  void
  restore(const Snapshot &snapshot)
  {
    accepted = snapshot.accepted;
    trial    = accepted;
    step     = snapshot.time_step;
  }

  /** Those of the last accepted state, by the cells' names. */
  CellData
  by_cell() const;

  /** Take the last accepted state from another distribution of the same cells.
   * Called by all processes. */
  void
  set(const CellData &data);

private:
  unsigned int
  first(const unsigned int cell, const unsigned int point) const;

  const Discretization<dim> &discretization;
  const unsigned int n_points;
  /** For each cell where its variables begin, and how many a point has. */
  std::vector<unsigned int> begin, n_of_point;
  std::vector<double> accepted, trial;
  double step = 0;
};
} // namespace Setsudan
