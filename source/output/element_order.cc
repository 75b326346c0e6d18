#include <deal.II/base/exceptions.h>

#include <setsudan/output/element_order.h>

namespace Setsudan
{
using namespace dealii;

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



template <int dim>
Edges
gmsh_edges()
{
  if (dim == 2)
    return vtk_edges<2>();
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



/** For each node of another program's element its number in ours. */
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
} // namespace



template <int dim>
std::vector<double>
coordinates(const PieceMesh<dim> &piece)
{
  std::vector<double> coordinates;
  for (const auto &node : piece.nodes)
    for (unsigned int d = 0; d < 3; ++d)
      coordinates.push_back(d < dim ? node[d % dim] : 0.);
  return coordinates;
}



template <int dim>
std::vector<std::size_t>
connectivity(const PieceMesh<dim> &piece,
             const Edges &edges,
             const std::size_t first_number)
{
  const auto order = node_order<dim>(edges);
  std::vector<std::size_t> nodes;
  for (const auto &element : piece.elements)
    for (const unsigned int node : order)
      nodes.push_back(first_number + element[node]);
  return nodes;
}



template Edges
vtk_edges<2>();
template Edges
gmsh_edges<2>();
template std::vector<double>
coordinates(const PieceMesh<2> &);
template std::vector<std::size_t>
connectivity(const PieceMesh<2> &, const Edges &, const std::size_t);
template Edges
vtk_edges<3>();
template Edges
gmsh_edges<3>();
template std::vector<double>
coordinates(const PieceMesh<3> &);
template std::vector<std::size_t>
connectivity(const PieceMesh<3> &, const Edges &, const std::size_t);
} // namespace Setsudan
