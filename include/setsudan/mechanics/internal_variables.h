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

  /** @param cell its active index. */
  dealii::ArrayView<const double>
  before(const unsigned int cell, const unsigned int point) const;

  dealii::ArrayView<double>
  after(const unsigned int cell, const unsigned int point);

  /** What after() has been set to. */
  dealii::ArrayView<const double>
  present(const unsigned int cell, const unsigned int point) const;

  /** Let the state that was solved for be the last accepted one. */
  void
  accept();

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
};
} // namespace Setsudan
