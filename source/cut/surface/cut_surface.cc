// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/surface/cut_surface.h>
#include <setsudan/mesh/geometry.h>

#include <cmath>
#include <map>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The lines of a face (in 2D its vertices): where it can meet other faces. */
template <int dim>
std::vector<EntityKey>
edges_of_face(const Body<dim> &body, const CellFace &face)
{
  const auto key_of = [&](const std::vector<unsigned int> &local_vertices) {
    std::vector<unsigned int> vertices;
    for (const unsigned int v : local_vertices)
      vertices.push_back(body.mesh.cells[face.first].vertices[v]);
    return make_entity_key(vertices);
  };
  std::vector<EntityKey> edges;
  if constexpr (dim == 2)
    for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_face; ++v)
      edges.push_back(
        key_of({GeometryInfo<dim>::face_to_cell_vertices(face.second, v)}));
  else
    for (unsigned int l = 0; l < GeometryInfo<dim>::lines_per_face; ++l)
      {
        const unsigned int line =
          GeometryInfo<dim>::face_to_cell_lines(face.second, l);
        edges.push_back(
          key_of({GeometryInfo<dim>::line_to_cell_vertices(line, 0),
                  GeometryInfo<dim>::line_to_cell_vertices(line, 1)}));
      }
  return edges;
}

template <int dim>
std::map<EntityKey, std::vector<unsigned int>>
faces_at_edges(const Body<dim> &body, const CutSurface<dim> &surface)
{
  std::map<EntityKey, std::vector<unsigned int>> faces;
  for (unsigned int f = 0; f < surface.size(); ++f)
    for (const auto &edge : edges_of_face(body, surface[f].minus))
      faces[edge].push_back(f);
  return faces;
}

template <int dim>
Tensor<1, dim>
area_vector(const Body<dim> &body, const CutFace<dim> &face)
{
  return area_vector_of_face(body.mesh.node_positions(face.minus.first),
                             face.minus.second);
}

/**
 * The way around a face's boundary in 3D, as seen against its normal: whether
 * it runs along an edge from the smaller to the larger vertex. Neighbors with
 * consistent normals run along their common edge in opposite ways.
 */
template <int dim>
bool
runs_upwards(const Body<dim> &body,
             const CutFace<dim> &face,
             const EntityKey &edge)
{
  const auto &vertices = body.mesh.vertices;
  if constexpr (dim == 3)
    {
      const auto nodes = body.mesh.node_positions(face.minus.first);
      Point<dim> center;
      for (unsigned int v = 0; v < 4; ++v)
        center +=
          0.25 *
          nodes[GeometryInfo<dim>::face_to_cell_vertices(face.minus.second, v)];
      const Tensor<1, dim> way = vertices[edge[1]] - vertices[edge[0]];
      return area_vector(body, face) *
               cross_product_3d(vertices[edge[0]] - center, way) >
             0;
    }
  // In 2D the face itself is a line: does its normal, turned by a right angle,
  // lead to this vertex?
  const auto nodes = body.mesh.node_positions(face.minus.first);
  const Point<dim> a =
    nodes[GeometryInfo<dim>::face_to_cell_vertices(face.minus.second, 0)];
  const Point<dim> b =
    nodes[GeometryInfo<dim>::face_to_cell_vertices(face.minus.second, 1)];
  const Tensor<1, dim> to_vertex = vertices[edge[0]] - (a + 0.5 * (b - a));
  const auto normal              = area_vector(body, face);
  return normal[0] * to_vertex[1] - normal[1] * to_vertex[0] > 0;
}

template <int dim>
void
turn(CutFace<dim> &face)
{
  std::swap(face.minus, face.plus);
}

/** Make the plus side of a connected part the conventional one. */
template <int dim>
void
choose_plus(const Body<dim> &body,
            CutSurface<dim> &surface,
            const std::vector<unsigned int> &part)
{
  CutSurface<dim> faces;
  double outward = 0;
  for (const unsigned int f : part)
    {
      faces.push_back(surface[f]);
      outward += area_vector(body, surface[f]) *
                 Tensor<1, dim>(body.mesh.cell_center(surface[f].minus.first));
    }
  const auto sum = measure_surface(body, faces);
  double sign    = outward;
  if (sum.vector.norm() > 1e-6 * sum.area)
    {
      sign = 0;
      for (unsigned int d = 0; d < dim; ++d)
        if (std::abs(sum.vector[d]) > std::abs(sign) * (1 + 1e-10))
          sign = sum.vector[d];
    }
  if (sign < 0)
    for (const unsigned int f : part)
      turn(surface[f]);
}
} // namespace


template <int dim>
std::vector<Tensor<1, dim>>
areas_of_faces(const Body<dim> &body, const CutSurface<dim> &surface)
{
  std::vector<Tensor<1, dim>> areas;
  for (const auto &face : surface)
    areas.push_back(area_vector(body, face));
  return areas;
}



template <int dim>
SurfaceArea<dim>
measure_surface(const Body<dim> &body, const CutSurface<dim> &surface)
{
  SurfaceArea<dim> sum;
  for (const auto &area : areas_of_faces(body, surface))
    {
      sum.vector += area;
      sum.area += area.norm();
    }
  return sum;
}



template <int dim>
std::vector<Point<dim>>
find_branchings(const Body<dim> &body, const CutSurface<dim> &surface)
{
  std::vector<Point<dim>> points;
  for (const auto &[edge, faces] : faces_at_edges(body, surface))
    if (faces.size() > 2)
      points.push_back(body.mesh.vertices[edge[0]]);
  return points;
}



template <int dim>
bool
orient_surface(const Body<dim> &body, CutSurface<dim> &surface)
{
  const auto faces = faces_at_edges(body, surface);
  std::vector<bool> visited(surface.size(), false);
  for (unsigned int first = 0; first < surface.size(); ++first)
    {
      if (visited[first])
        continue;
      std::vector<unsigned int> part(1, first);
      visited[first] = true;
      for (unsigned int i = 0; i < part.size(); ++i)
        for (const auto &edge : edges_of_face(body, surface[part[i]].minus))
          for (const unsigned int other : faces.at(edge))
            {
              if (other == part[i])
                continue;
              const bool consistent =
                runs_upwards(body, surface[part[i]], edge) !=
                runs_upwards(body, surface[other], edge);
              if (visited[other] && !consistent)
                return false;
              if (visited[other])
                continue;
              if (!consistent)
                turn(surface[other]);
              visited[other] = true;
              part.push_back(other);
            }
      choose_plus(body, surface, part);
    }
  return true;
}



template std::vector<Tensor<1, 2>>
areas_of_faces(const Body<2> &, const CutSurface<2> &);
template std::vector<Tensor<1, 3>>
areas_of_faces(const Body<3> &, const CutSurface<3> &);
template SurfaceArea<2>
measure_surface(const Body<2> &, const CutSurface<2> &);
template SurfaceArea<3>
measure_surface(const Body<3> &, const CutSurface<3> &);
template std::vector<Point<2>>
find_branchings(const Body<2> &, const CutSurface<2> &);
template std::vector<Point<3>>
find_branchings(const Body<3> &, const CutSurface<3> &);
template bool
orient_surface(const Body<2> &, CutSurface<2> &);
template bool
orient_surface(const Body<3> &, CutSurface<3> &);
} // namespace Setsudan
