// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <setsudan/mesh/node_order.h>
#include <setsudan/mesh/nodes.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
Edges
gmsh_edges()
{
  if (dim == 2)
    return {{{0, 1}}, {{1, 2}}, {{2, 3}}, {{3, 0}}};
  return {{{0, 1}},
          {{0, 3}},
          {{0, 4}},
          {{1, 2}},
          {{1, 5}},
          {{2, 3}},
          {{2, 6}},
          {{3, 7}},
          {{4, 5}},
          {{4, 7}},
          {{5, 6}},
          {{6, 7}}};
}



template <int dim>
Edges
vtk_edges()
{
  Edges edges = {{{0, 1}}, {{1, 2}}, {{2, 3}}, {{3, 0}}};
  if (dim == 3)
    edges.insert(edges.end(),
                 {{{4, 5}},
                  {{5, 6}},
                  {{6, 7}},
                  {{7, 4}},
                  {{0, 4}},
                  {{1, 5}},
                  {{2, 6}},
                  {{3, 7}}});
  return edges;
}



namespace
{
/** Corners of a cell in the order of gmsh and VTK: around the bottom, then
 * around the top. */
template <int dim>
std::vector<unsigned int>
corner_order()
{
  if (dim == 2)
    return {0, 1, 3, 2};
  return {0, 1, 3, 2, 4, 5, 7, 6};
}
} // namespace


template <int dim>
std::vector<unsigned int>
node_order(const Edges &edges)
{
  const auto corners = corner_order<dim>();
  auto order         = corners;
  for (const auto &edge : edges)
    for (unsigned int node = GeometryInfo<dim>::vertices_per_cell;
         node < n_element_nodes<dim>;
         ++node)
      {
        const auto ends      = vertices_of_node<dim>(node);
        const unsigned int a = corners[edge[0]], b = corners[edge[1]];
        if ((ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a))
          order.push_back(node);
      }
  AssertDimension(order.size(), n_element_nodes<dim>);
  return order;
}



template Edges
gmsh_edges<2>();
template Edges
gmsh_edges<3>();
template Edges
vtk_edges<2>();
template Edges
vtk_edges<3>();
template std::vector<unsigned int>
node_order<2>(const Edges &);
template std::vector<unsigned int>
node_order<3>(const Edges &);
} // namespace Setsudan
