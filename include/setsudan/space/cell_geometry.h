// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_values.h>

#include <setsudan/space/cell_shapes.h>

#include <vector>

namespace Setsudan
{
/** The geometry of one cell in the form that kernels take (see CellBatch). */
template <int dim>
class CellGeometry
{
public:
  using Cell = typename Discretization<dim>::Cell;

  explicit CellGeometry(const Discretization<dim> &discretization);

  /** Go to a cell.
   *
   * @return whether nothing has changed, since it has the shape of the last. */
  bool
  reinit(const Cell &cell);

  /** [point][r][direction] */
  const std::vector<double> &
  gradients() const;

  /** [point][dim + 1] */
  const std::vector<double> &
  pressures();

private:
  void
  find_gradients();

  void
  find_pressures();

  CellShapes<dim> shapes;
  const dealii::FE_DGQ<dim> no_element;
  dealii::FEValues<dim> fe_values;
  std::vector<double> scaled_gradients;
  /** Empty until somebody asks. */
  std::vector<double> basis;
};
} // namespace Setsudan
