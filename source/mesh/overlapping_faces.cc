// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/numerics/rtree.h>

#include <setsudan/mesh/geometry.h>
#include <setsudan/mesh/overlapping_faces.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace Setsudan
{
using namespace dealii;

namespace
{
// Relative to the size of a face. Curved faces are apart where one side is
// meshed finer.
constexpr double tolerance_of_faces = 1e-3;

/** A face of the surface. */
template <int dim>
struct SurfaceFace
{
  CellFace face;
  Point<dim> center;
  Tensor<1, dim> normal;
  /** The longest of the extents along the axes. */
  double size;
  BoundingBox<dim> box;
};

template <int dim>
Point<dim>
center_of_unit_face(const unsigned int face)
{
  Point<dim> center;
  for (unsigned int d = 0; d < dim; ++d)
    center[d] = d == face / 2 ? face % 2 : 0.5;
  return center;
}

template <int dim>
SurfaceFace<dim>
describe_face(const CoarseMesh<dim> &mesh, const CellFace &face)
{
  // The shape functions in the middle of a face.
  constexpr double value_of_corner = dim == 3 ? -0.25 : 0;
  constexpr double value_of_middle = dim == 3 ? 0.5 : 1;
  const auto nodes                 = mesh.node_positions(face.first);
  std::vector<Point<dim>> of_face;
  Point<dim> center;
  for (unsigned int node = 0; node < nodes.size(); ++node)
    if (node_is_on_face<dim>(node, face.second))
      {
        of_face.push_back(nodes[node]);
        center +=
          (node < GeometryInfo<dim>::vertices_per_cell ? value_of_corner
                                                       : value_of_middle) *
          nodes[node];
      }
  BoundingBox<dim> box(of_face);
  double size = 0;
  for (unsigned int d = 0; d < dim; ++d)
    size = std::max(size, box.side_length(d));
  // Between its nodes a curved face may leave the box.
  box.extend(0.05 * size);
  const auto area = area_vector_of_face(nodes, face.second);
  return {face, center, area / area.norm(), size, box};
}

/** Whether a point lies in a face, which is curved, up to `tolerance`. */
template <int dim>
bool
is_in_face(const ElementNodes<dim> &nodes,
           const unsigned int face,
           const Point<dim> &point,
           const double tolerance)
{
  const unsigned int axis = face / 2;
  Point<dim> unit_point   = center_of_unit_face<dim>(face);
  double distance         = std::numeric_limits<double>::max();
  for (unsigned int step = 0; step < 10; ++step)
    {
      // Along the face and away from it.
      auto directions   = jacobian_of_element(nodes, unit_point);
      const auto normal = normal_of_face(nodes, face, unit_point);
      for (unsigned int d = 0; d < dim; ++d)
        directions[d][axis] = normal[d];
      const Tensor<1, dim> way =
        invert(directions) * (point - point_of_element(nodes, unit_point));
      distance = std::abs(way[axis]);
      for (unsigned int d = 0; d < dim; ++d)
        if (d != axis)
          unit_point[d] = std::clamp(unit_point[d] + way[d], -0.5, 1.5);
    }
  for (unsigned int d = 0; d < dim; ++d)
    if (unit_point[d] < -tolerance_of_faces ||
        unit_point[d] > 1 + tolerance_of_faces)
      return false;
  return distance <= tolerance;
}

/** The places of a face's vertices, ascending. */
template <int dim>
std::vector<unsigned int>
places_of_face(const CoarseMesh<dim> &mesh,
               const CellFace &face,
               const std::vector<unsigned int> &places)
{
  const auto key = mesh.face_key(face);
  std::vector<unsigned int> of_face;
  for (unsigned int v = 0; v < n_vertices(key); ++v)
    of_face.push_back(places[key[v]]);
  std::sort(of_face.begin(), of_face.end());
  return of_face;
}
} // namespace


template <int dim>
std::vector<CellFace>
find_overlapping_faces(const CoarseMesh<dim> &mesh,
                       const std::vector<CellFace> &surface,
                       const std::vector<unsigned int> &places)
{
  std::vector<SurfaceFace<dim>> faces;
  std::vector<BoundingBox<dim>> boxes;
  for (const auto &face : surface)
    {
      faces.push_back(describe_face(mesh, face));
      boxes.push_back(faces.back().box);
    }
  const auto tree   = pack_rtree_of_indices(boxes);
  const auto lie_on = [&](const SurfaceFace<dim> &a,
                          const SurfaceFace<dim> &b) {
    return a.normal * b.normal < -0.9 &&
           places_of_face(mesh, a.face, places) !=
             places_of_face(mesh, b.face, places) &&
           is_in_face<dim>(mesh.node_positions(b.face.first),
                           b.face.second,
                           a.center,
                           tolerance_of_faces * std::min(a.size, b.size));
  };
  std::vector<CellFace> found;
  std::vector<unsigned int> near;
  for (const auto &face : faces)
    {
      near.clear();
      tree.query(boost::geometry::index::intersects(face.center),
                 std::back_inserter(near));
      for (const unsigned int other : near)
        if (lie_on(face, faces[other]))
          {
            found.push_back(face.face);
            break;
          }
    }
  return found;
}



template std::vector<CellFace>
find_overlapping_faces(const CoarseMesh<2> &,
                       const std::vector<CellFace> &,
                       const std::vector<unsigned int> &);
template std::vector<CellFace>
find_overlapping_faces(const CoarseMesh<3> &,
                       const std::vector<CellFace> &,
                       const std::vector<unsigned int> &);
} // namespace Setsudan
