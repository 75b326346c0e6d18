#include <deal.II/base/bounding_box.h>
#include <deal.II/grid/grid_tools.h>

#include <setsudan/body/coarse_mesh.h>
#include <setsudan/body/nodes.h>

#include <algorithm>
#include <limits>

namespace Setsudan
{
using namespace dealii;

template <int dim>
FaceKey
CoarseMesh<dim>::face_key(const CellFace &face) const
{
  FaceKey key(GeometryInfo<dim>::vertices_per_face);
  for (unsigned int v = 0; v < key.size(); ++v)
    key[v] =
      cells[face.first]
        .vertices[GeometryInfo<dim>::face_to_cell_vertices(face.second, v)];
  std::sort(key.begin(), key.end());
  return key;
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
  const auto ends = vertices_of_node<dim>(node);
  const auto &a   = vertices[cells[cell].vertices[ends[0]]];
  const auto &b   = vertices[cells[cell].vertices[ends[1]]];
  return a + 0.5 * (b - a);
}



template <int dim>
double
CoarseMesh<dim>::cell_volume(const unsigned int cell) const
{
  return GridTools::cell_measure<dim>(vertices,
                                      make_array_view(cells[cell].vertices));
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
std::vector<std::vector<unsigned int>>
collect_neighbors(const CoarseMesh<dim> &mesh)
{
  std::map<FaceKey, unsigned int> first_cell;
  std::vector<std::vector<unsigned int>> neighbors(mesh.cells.size());
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    for (unsigned int face = 0; face < GeometryInfo<dim>::faces_per_cell;
         ++face)
      {
        const auto inserted =
          first_cell.emplace(mesh.face_key({cell, face}), cell);
        if (!inserted.second)
          {
            const unsigned int other = inserted.first->second;
            neighbors[cell].push_back(other);
            neighbors[other].push_back(cell);
          }
      }
  return neighbors;
}



namespace
{
/** The boundary faces as deal.II wants them: by their vertices, in order. */
template <int dim>
SubCellData
boundary_description(const CoarseMesh<dim> &mesh)
{
  SubCellData description;
  for (const auto &[face, id] : mesh.boundary_ids)
    {
      CellData<dim - 1> data(GeometryInfo<dim>::vertices_per_face);
      for (unsigned int v = 0; v < data.vertices.size(); ++v)
        data.vertices[v] =
          mesh.cells[face.first]
            .vertices[GeometryInfo<dim>::face_to_cell_vertices(face.second, v)];
      data.boundary_id = id;
      if constexpr (dim == 3)
        description.boundary_quads.push_back(data);
      else
        description.boundary_lines.push_back(data);
    }
  return description;
}
} // namespace


template <int dim>
void
create_triangulation(const CoarseMesh<dim> &mesh,
                     Triangulation<dim> &triangulation)
{
  triangulation.create_triangulation(
    mesh.vertices, mesh.cells, boundary_description(mesh));
}



template <int dim>
std::vector<unsigned int>
find_pieces(const CoarseMesh<dim> &mesh)
{
  constexpr unsigned int unvisited = std::numeric_limits<unsigned int>::max();
  const auto neighbors             = collect_neighbors(mesh);
  std::vector<unsigned int> piece(mesh.cells.size(), unvisited);
  unsigned int n_pieces = 0;
  for (unsigned int first = 0; first < mesh.cells.size(); ++first)
    if (piece[first] == unvisited)
      {
        std::vector<unsigned int> front(1, first);
        piece[first] = n_pieces;
        while (!front.empty())
          {
            const unsigned int cell = front.back();
            front.pop_back();
            for (const unsigned int neighbor : neighbors[cell])
              if (piece[neighbor] == unvisited)
                {
                  piece[neighbor] = n_pieces;
                  front.push_back(neighbor);
                }
          }
        ++n_pieces;
      }
  return piece;
}



template struct CoarseMesh<2>;
template struct CoarseMesh<3>;
template std::vector<std::vector<unsigned int>>
collect_neighbors(const CoarseMesh<2> &);
template std::vector<std::vector<unsigned int>>
collect_neighbors(const CoarseMesh<3> &);
template void
create_triangulation(const CoarseMesh<2> &, Triangulation<2> &);
template void
create_triangulation(const CoarseMesh<3> &, Triangulation<3> &);
template std::vector<unsigned int>
find_pieces(const CoarseMesh<2> &);
template std::vector<unsigned int>
find_pieces(const CoarseMesh<3> &);
} // namespace Setsudan
