#include <deal.II/base/exceptions.h>

#include <setsudan/cut/mesh_surgery.h>

#include <algorithm>
#include <set>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The cells around the vertices of a cut, and the faces that join them. */
template <int dim>
class Fans
{
public:
  Fans(const CoarseMesh<dim> &mesh, const CutSurface<dim> &surface)
    : mesh(mesh)
  {
    for (const auto &face : surface)
      {
        const FaceKey key = mesh.face_key(face.minus);
        Assert(key == mesh.face_key(face.plus),
               ExcMessage("The two cells of a cut face do not share it."));
        cut.insert(key);
        for (const unsigned int vertex : key)
          cells_at[vertex];
      }
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      for (const unsigned int vertex : mesh.cells[cell].vertices)
        {
          const auto fan = cells_at.find(vertex);
          if (fan != cells_at.end())
            fan->second.push_back(cell);
        }
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
    std::map<FaceKey, std::vector<unsigned int>> cells_of_face;
    for (const unsigned int cell : fan)
      for (unsigned int f = 0; f < GeometryInfo<dim>::faces_per_cell; ++f)
        {
          const FaceKey key = mesh.face_key({cell, f});
          if (std::binary_search(key.begin(), key.end(), vertex) &&
              cut.count(key) == 0)
            cells_of_face[key].push_back(cell);
        }

    std::map<unsigned int, unsigned int> component;
    for (const unsigned int cell : fan)
      component[cell] = cell;
    // Fans are small: let the smaller name spread until nothing changes.
    for (bool changed = true; changed;)
      {
        changed = false;
        for (const auto &[key, cells] : cells_of_face)
          for (const unsigned int a : cells)
            for (const unsigned int b : cells)
              if (component[a] < component[b])
                {
                  component[b] = component[a];
                  changed      = true;
                }
      }

    std::map<unsigned int, std::vector<unsigned int>> sorted;
    for (const auto &[cell, name] : component)
      sorted[name].push_back(cell);
    std::vector<std::vector<unsigned int>> components;
    for (const auto &[name, cells] : sorted)
      components.push_back(cells);
    return components;
  }

private:
  const CoarseMesh<dim> &mesh;
  std::set<FaceKey> cut;
  std::map<unsigned int, std::vector<unsigned int>> cells_at;
};
} // namespace


template <int dim>
CoarseMesh<dim>
split_mesh(const CoarseMesh<dim> &mesh, const CutSurface<dim> &surface)
{
  CoarseMesh<dim> split = mesh;
  const Fans<dim> fans(mesh, surface);
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
  // A face whose vertices all stayed joined (a cut that separates nothing
  // there) stays inside the body.
  for (const auto &face : surface)
    if (split.face_key(face.minus) != split.face_key(face.plus))
      {
        split.boundary_ids[face.minus] = cut_minus_id;
        split.boundary_ids[face.plus]  = cut_plus_id;
      }
  return split;
}



template CoarseMesh<2>
split_mesh(const CoarseMesh<2> &, const CutSurface<2> &);
template CoarseMesh<3>
split_mesh(const CoarseMesh<3> &, const CutSurface<3> &);
} // namespace Setsudan
