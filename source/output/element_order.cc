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
std::vector<double>
coordinates(const std::vector<Point<dim>> &vectors)
{
  std::vector<double> coordinates;
  for (const auto &vector : vectors)
    for (unsigned int d = 0; d < 3; ++d)
      coordinates.push_back(d < dim ? vector[d % dim] : 0.);
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
template std::vector<double>
coordinates(const std::vector<Point<2>> &);
template std::vector<std::size_t>
connectivity(const PieceMesh<2> &, const Edges &, const std::size_t);
template Edges
vtk_edges<3>();
template std::vector<double>
coordinates(const std::vector<Point<3>> &);
template std::vector<std::size_t>
connectivity(const PieceMesh<3> &, const Edges &, const std::size_t);
} // namespace Setsudan
