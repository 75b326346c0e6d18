// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mesh/nodes.h>

#include <cmath>

namespace Setsudan
{
using namespace dealii;

template <int dim>
std::array<unsigned int, 2>
vertices_of_node(const unsigned int node)
{
  AssertIndexRange(node, n_element_nodes<dim>);
  constexpr unsigned int n_vertices = GeometryInfo<dim>::vertices_per_cell;
  if (node < n_vertices)
    return {{node, node}};
  return {{GeometryInfo<dim>::line_to_cell_vertices(node - n_vertices, 0),
           GeometryInfo<dim>::line_to_cell_vertices(node - n_vertices, 1)}};
}



template <int dim>
Point<dim>
unit_point_of_node(const unsigned int node)
{
  const auto vertices = vertices_of_node<dim>(node);
  return Point<dim>(
    0.5 * (Tensor<1, dim>(GeometryInfo<dim>::unit_cell_vertex(vertices[0])) +
           Tensor<1, dim>(GeometryInfo<dim>::unit_cell_vertex(vertices[1]))));
}



template <int dim>
std::optional<unsigned int>
node_at(const Point<dim> &unit_point)
{
  for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
    if (unit_point == unit_point_of_node<dim>(node))
      return node;
  return {};
}



template <int dim>
bool
node_is_on_face(const unsigned int node, const unsigned int face)
{
  // Faces 2i and 2i + 1 are where coordinate i of the reference cell is 0
  // and 1.
  return unit_point_of_node<dim>(node)[face / 2] == face % 2;
}



template std::array<unsigned int, 2>
vertices_of_node<2>(const unsigned int);
template std::array<unsigned int, 2>
vertices_of_node<3>(const unsigned int);
template Point<2>
unit_point_of_node<2>(const unsigned int);
template Point<3>
unit_point_of_node<3>(const unsigned int);
template std::optional<unsigned int>
node_at(const Point<2> &);
template std::optional<unsigned int>
node_at(const Point<3> &);
template bool
node_is_on_face<2>(const unsigned int, const unsigned int);
template bool
node_is_on_face<3>(const unsigned int, const unsigned int);
} // namespace Setsudan
