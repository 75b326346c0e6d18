// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/grid/grid_tools.h>

#include <setsudan/body/directions.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

namespace
{
template <int dim>
constexpr unsigned int n_corners = GeometryInfo<dim>::vertices_per_cell;

/** Local numbers that corners had before, in their new order. */
template <int dim>
using CornerOrder = std::array<unsigned int, n_corners<dim>>;

/** The node between two corners, and at each corner. */
template <int dim>
using NodeTable = std::array<CornerOrder<dim>, n_corners<dim>>;

template <int dim>
NodeTable<dim>
tabulate_nodes()
{
  NodeTable<dim> table = {};
  for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
    {
      const auto ends         = vertices_of_node<dim>(node);
      table[ends[0]][ends[1]] = table[ends[1]][ends[0]] = node;
    }
  return table;
}

template <int dim>
void
relabel(const CornerOrder<dim> &order, const unsigned int cell, Body<dim> &body)
{
  static const auto node_between = tabulate_nodes<dim>();
  const auto vertices            = body.mesh.cells[cell].vertices;
  const auto numbers             = body.node_numbers[cell];
  const auto positions           = body.mesh.node_positions(cell);
  for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
    {
      const auto ends           = vertices_of_node<dim>(node);
      const unsigned int before = node_between[order[ends[0]]][order[ends[1]]];
      body.node_numbers[cell][node] = numbers[before];
      if (node < n_corners<dim>)
        body.mesh.cells[cell].vertices[node] = vertices[before];
      else if (body.mesh.is_curved())
        body.mesh.line_nodes[cell][node - n_corners<dim>] = positions[before];
    }
}
} // namespace


template <int dim>
void
make_counterclockwise(Body<dim> &body)
{
  if constexpr (dim == 2)
    for (unsigned int cell = 0; cell < body.mesh.cells.size(); ++cell)
      {
        const auto nodes = body.mesh.node_positions(cell);
        const auto a = nodes[3] - nodes[0], b = nodes[2] - nodes[1];
        if (a[0] * b[1] - a[1] * b[0] < 0)
          relabel<dim>({{0, 2, 1, 3}}, cell, body);
      }
}



template <int dim>
void
make_lines_consistent(Body<dim> &body)
{
  auto cells = body.mesh.cells;
  GridTools::consistently_order_cells(cells);
  for (unsigned int cell = 0; cell < cells.size(); ++cell)
    {
      const auto &before = body.mesh.cells[cell].vertices;
      CornerOrder<dim> order;
      for (unsigned int v = 0; v < n_corners<dim>; ++v)
        order[v] =
          std::find(before.begin(), before.end(), cells[cell].vertices[v]) -
          before.begin();
      relabel<dim>(order, cell, body);
    }
}



template void
make_counterclockwise(Body<2> &);
template void
make_counterclockwise(Body<3> &);
template void
make_lines_consistent(Body<2> &);
template void
make_lines_consistent(Body<3> &);
} // namespace Setsudan
