// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/bounding_box.h>

#include <setsudan/mesh/coarse_mesh.h>

#include <algorithm>
#include <limits>
namespace Setsudan
{
using namespace dealii;

template <int dim>
bool
CoarseMesh<dim>::is_curved() const
{
  return !line_nodes.empty();
}



template <int dim>
std::array<unsigned int, GeometryInfo<dim>::vertices_per_face>
CoarseMesh<dim>::face_vertices(const CellFace &face) const
{
  std::array<unsigned int, GeometryInfo<dim>::vertices_per_face> of_face;
  for (unsigned int v = 0; v < of_face.size(); ++v)
    of_face[v] =
      cells[face.first]
        .vertices[GeometryInfo<dim>::face_to_cell_vertices(face.second, v)];
  return of_face;
}



template <int dim>
EntityKey
CoarseMesh<dim>::face_key(const CellFace &face) const
{
  return make_entity_key(face_vertices(face));
}



template <int dim>
Point<dim>
CoarseMesh<dim>::cell_center(const unsigned int cell) const
{
  Point<dim> center;
  for (const unsigned int vertex : cells[cell].vertices)
    center += vertices[vertex] / double(cells[cell].vertices.size());
  return center;
}



template <int dim>
Point<dim>
CoarseMesh<dim>::node_position(const unsigned int cell,
                               const unsigned int node) const
{
  constexpr unsigned int n_corners = GeometryInfo<dim>::vertices_per_cell;
  if (is_curved() && node >= n_corners)
    return line_nodes[cell][node - n_corners];
  const auto ends = vertices_of_node<dim>(node);
  const auto &a   = vertices[cells[cell].vertices[ends[0]]];
  const auto &b   = vertices[cells[cell].vertices[ends[1]]];
  return a + 0.5 * (b - a);
}



template <int dim>
ElementNodes<dim>
CoarseMesh<dim>::node_positions(const unsigned int cell) const
{
  ElementNodes<dim> positions;
  for (unsigned int node = 0; node < positions.size(); ++node)
    positions[node] = node_position(cell, node);
  return positions;
}



template <int dim>
double
CoarseMesh<dim>::extent() const
{
  const BoundingBox<dim> box(vertices);
  double extent = 0;
  for (unsigned int d = 0; d < dim; ++d)
    extent = std::max(extent, box.side_length(d));
  return extent;
}



template <int dim>
double
CoarseMesh<dim>::round_off() const
{
  double farthest = 0, shortest = std::numeric_limits<double>::max();
  for (const auto &vertex : vertices)
    farthest = std::max(farthest, vertex.norm());
  for (const auto &cell : cells)
    for (unsigned int l = 0; l < GeometryInfo<dim>::lines_per_cell; ++l)
      {
        const auto end = [&](const unsigned int v) {
          return vertices
            [cell.vertices[GeometryInfo<dim>::line_to_cell_vertices(l, v)]];
        };
        shortest = std::min(shortest, end(0).distance(end(1)));
      }
  return farthest / shortest * std::numeric_limits<double>::epsilon();
}



template <int dim>
void
create_triangulation(const CoarseMesh<dim> &mesh,
                     Triangulation<dim> &triangulation)
{
  triangulation.create_triangulation(mesh.vertices, mesh.cells, SubCellData());
}



template struct CoarseMesh<2>;
template struct CoarseMesh<3>;
template void
create_triangulation(const CoarseMesh<2> &, Triangulation<2> &);
template void
create_triangulation(const CoarseMesh<3> &, Triangulation<3> &);
} // namespace Setsudan
