// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/output/frames/vtu.h>
#include <setsudan/output/pieces/element_order.h>
#include <setsudan/output/pieces/piece_mesh.h>

#include <numeric>
#include <ostream>

namespace Setsudan
{
namespace
{
VtuArray
numbers(const std::string &name, const std::vector<unsigned int> &values)
{
  return {name, 1, std::vector<std::int32_t>(values.begin(), values.end())};
}

VtuArray
counted(const std::string &name, const unsigned int n)
{
  std::vector<std::int32_t> values(n);
  std::iota(values.begin(), values.end(), 0);
  return {name, 1, values};
}
} // namespace



template <int dim>
VtuGrid
grid_of_piece(const PieceMesh<dim> &piece)
{
  VtuGrid grid;
  // VTK's quadratic quadrilateral and quadratic hexahedron.
  grid.type             = dim == 2 ? 23 : 25;
  grid.n_points_of_cell = n_element_nodes<dim>;
  grid.points           = coordinates<dim>(piece.nodes);
  const auto nodes      = connectivity(piece, vtk_edges<dim>(), 0);
  grid.connectivity.assign(nodes.begin(), nodes.end());
  grid.point_data = {counted("node", piece.nodes.size()),
                     numbers("node_in_body", piece.numbers_in_body)};
  grid.cell_data  = {counted("element", piece.elements.size()),
                     numbers("element_in_body", piece.elements_in_body)};
  return grid;
}



template <int dim>
void
write_piece_vtu(const PieceMesh<dim> &piece,
                const OutputDirectory &directory,
                const std::string &name)
{
  VtuGrid grid = grid_of_piece(piece);
  grid.point_data.push_back({"displacement",
                             3,
                             coordinates<dim>(piece.displacements),
                             {"X", "Y", "Z"}});
  grid.cell_data.push_back(numbers("material", piece.materials));
  directory.write(name, [&](std::ostream &out) { write_vtu(grid, out); });
}



template VtuGrid
grid_of_piece(const PieceMesh<2> &);
template VtuGrid
grid_of_piece(const PieceMesh<3> &);
template void
write_piece_vtu(const PieceMesh<2> &,
                const OutputDirectory &,
                const std::string &);
template void
write_piece_vtu(const PieceMesh<3> &,
                const OutputDirectory &,
                const std::string &);
} // namespace Setsudan
