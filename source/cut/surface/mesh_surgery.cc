// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/surface/mesh_surgery.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The cells around the vertices of a cut, and the faces that join them. */
template <int dim>
class VertexPatches
{
public:
  VertexPatches(const CoarseMesh<dim> &mesh, const CutSurface<dim> &surface)
    : mesh(mesh)
  {
    for (const auto &face : surface)
      {
        cut.push_back(mesh.face_key(face.minus));
        for (const unsigned int vertex : cut.back())
          if (vertex != numbers::invalid_unsigned_int)
            cells_at[vertex];
      }
    std::sort(cut.begin(), cut.end());

    // All cells are looked at once; a bit for each vertex makes that quick.
    std::vector<bool> on_cut(mesh.vertices.size(), false);
    for (const auto &[vertex, cells] : cells_at)
      on_cut[vertex] = true;
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      for (const unsigned int vertex : mesh.cells[cell].vertices)
        if (on_cut[vertex])
          cells_at[vertex].push_back(cell);
  }

  /** The vertices of the cut, in order, each with its fan of cells. */
  const std::map<unsigned int, std::vector<unsigned int>> &
  at_vertices() const
  {
    return cells_at;
  }

  /** The fan of a vertex in components that faces off the cut hold together:
   * each sorted, the one with the smallest cell first. */
  std::vector<std::vector<unsigned int>>
  components(const unsigned int vertex) const
  {
    // Two cells of the fan are neighbors if they have a face at the vertex.
    const std::vector<unsigned int> &fan = cells_at.at(vertex);
    std::vector<std::pair<EntityKey, unsigned int>> faces;
    for (unsigned int i = 0; i < fan.size(); ++i)
      for (unsigned int f = 0; f < GeometryInfo<dim>::faces_per_cell; ++f)
        {
          const EntityKey key = mesh.face_key({fan[i], f});
          if (std::binary_search(key.begin(), key.end(), vertex) &&
              !std::binary_search(cut.begin(), cut.end(), key))
            faces.emplace_back(key, i);
        }
    std::sort(faces.begin(), faces.end());

    std::vector<unsigned int> name(fan.size());
    std::iota(name.begin(), name.end(), 0);
    // VertexPatches are small: let the smaller name spread until nothing
    // changes.
    for (bool changed = true; changed;)
      {
        changed = false;
        for (unsigned int i = 0; i + 1 < faces.size(); ++i)
          if (faces[i].first == faces[i + 1].first)
            {
              unsigned int &a = name[faces[i].second];
              unsigned int &b = name[faces[i + 1].second];
              changed         = changed || a != b;
              a = b = std::min(a, b);
            }
      }

    std::map<unsigned int, std::vector<unsigned int>> sorted;
    for (unsigned int i = 0; i < fan.size(); ++i)
      sorted[name[i]].push_back(fan[i]);
    std::vector<std::vector<unsigned int>> components;
    for (const auto &[first, cells] : sorted)
      components.push_back(cells);
    return components;
  }

private:
  const CoarseMesh<dim> &mesh;
  std::vector<EntityKey> cut;
  std::map<unsigned int, std::vector<unsigned int>> cells_at;
};
} // namespace


template <int dim>
CoarseMesh<dim>
split_mesh(const CoarseMesh<dim> &mesh, const CutSurface<dim> &surface)
{
  CoarseMesh<dim> split = mesh;
  const VertexPatches<dim> fans(mesh, joined_faces(mesh, surface));
  for (const auto &[vertex, fan] : fans.at_vertices())
    {
      const auto components = fans.components(vertex);
      for (unsigned int c = 1; c < components.size(); ++c)
        {
          const unsigned int copy = split.vertices.size();
          split.vertices.push_back(mesh.vertices[vertex]);
          for (const unsigned int cell : components[c])
            {
              auto &vertices = split.cells[cell].vertices;
              std::replace(vertices.begin(), vertices.end(), vertex, copy);
            }
        }
    }
  return split;
}



template <int dim>
CutSurface<dim>
joined_faces(const CoarseMesh<dim> &mesh, const CutSurface<dim> &surface)
{
  CutSurface<dim> joined;
  for (const auto &face : surface)
    if (mesh.face_key(face.minus) == mesh.face_key(face.plus))
      joined.push_back(face);
  return joined;
}



template CoarseMesh<2>
split_mesh(const CoarseMesh<2> &, const CutSurface<2> &);
template CoarseMesh<3>
split_mesh(const CoarseMesh<3> &, const CutSurface<3> &);
template CutSurface<2>
joined_faces(const CoarseMesh<2> &, const CutSurface<2> &);
template CutSurface<3>
joined_faces(const CoarseMesh<3> &, const CutSurface<3> &);
} // namespace Setsudan
