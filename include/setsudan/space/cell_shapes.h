// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/space/discretization.h>

#include <vector>

namespace Setsudan
{
/** Tells which cells have the same shape as the one before, so that what
 * depends on nothing else is computed once for a whole box. */
template <int dim>
class CellShapes
{
public:
  using Cell = typename Discretization<dim>::Cell;

  explicit CellShapes(const Discretization<dim> &discretization);

  /** Whether the cell has the shape of the last one, up to round-off and a
   * translation. It is the last one from then on, if it has not. */
  bool
  is_last(const Cell &cell);

private:
  /** The corners of a cell, or all nodes where the body is curved, relative to
   * its first. */
  std::vector<dealii::Tensor<1, dim>>
  shape_of(const Cell &cell) const;

  const Discretization<dim> &discretization;
  std::vector<dealii::Tensor<1, dim>> last_shape;
};
} // namespace Setsudan
