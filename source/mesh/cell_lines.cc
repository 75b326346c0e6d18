// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mesh/cell_lines.h>

#include <algorithm>
#include <tuple>

namespace Setsudan
{
using namespace dealii;

template <int dim>
std::vector<CellLine>
collect_lines(const CoarseMesh<dim> &mesh)
{
  std::vector<CellLine> lines;
  lines.reserve(mesh.cells.size() * GeometryInfo<dim>::lines_per_cell);
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    for (unsigned int node = GeometryInfo<dim>::vertices_per_cell;
         node < n_element_nodes<dim>;
         ++node)
      {
        const auto &vertices = mesh.cells[cell].vertices;
        const auto ends      = vertices_of_node<dim>(node);
        const unsigned int a = vertices[ends[0]], b = vertices[ends[1]];
        lines.push_back({{{std::min(a, b), std::max(a, b)}}, cell, node});
      }
  std::sort(lines.begin(), lines.end(), [](const auto &a, const auto &b) {
    return std::tie(a.vertices, a.cell, a.node) <
           std::tie(b.vertices, b.cell, b.node);
  });
  return lines;
}



template std::vector<CellLine>
collect_lines(const CoarseMesh<2> &);
template std::vector<CellLine>
collect_lines(const CoarseMesh<3> &);
} // namespace Setsudan
