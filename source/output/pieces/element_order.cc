// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/output/pieces/element_order.h>

namespace Setsudan
{
using namespace dealii;

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



template std::vector<double>
coordinates(const std::vector<Point<2>> &);
template std::vector<std::size_t>
connectivity(const PieceMesh<2> &, const Edges &, const std::size_t);
template std::vector<double>
coordinates(const std::vector<Point<3>> &);
template std::vector<std::size_t>
connectivity(const PieceMesh<3> &, const Edges &, const std::size_t);
} // namespace Setsudan
