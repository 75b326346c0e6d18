// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/space/cell_shapes.h>

#include <limits>

namespace Setsudan
{
using namespace dealii;

template <int dim>
CellShapes<dim>::CellShapes(const Discretization<dim> &discretization)
  : discretization(discretization)
{
}



template <int dim>
bool
CellShapes<dim>::is_last(const Cell &cell)
{
  auto shape = shape_of(cell);
  // The cells of a box differ by the round-off of their vertices' coordinates.
  const double tolerance = 16 * std::numeric_limits<double>::epsilon() *
                           (cell->vertex(0).norm() + cell->diameter());
  bool is_same = !last_shape.empty();
  for (unsigned int i = 0; is_same && i < shape.size(); ++i)
    is_same = (shape[i] - last_shape[i]).norm() <= tolerance;
  if (!is_same)
    last_shape = std::move(shape);
  return is_same;
}



template <int dim>
std::vector<Tensor<1, dim>>
CellShapes<dim>::shape_of(const Cell &cell) const
{
  std::vector<Tensor<1, dim>> shape;
  if (discretization.is_curved())
    {
      const auto nodes = discretization.node_positions(cell);
      for (const auto &node : nodes)
        shape.push_back(node - nodes[0]);
    }
  else
    for (const unsigned int v : cell->vertex_indices())
      shape.push_back(cell->vertex(v) - cell->vertex(0));
  return shape;
}



template class CellShapes<2>;
template class CellShapes<3>;
} // namespace Setsudan
