// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/surface/neighborhood.h>
#include <setsudan/mesh/geometry.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The distance of a point from a segment. */
template <int dim>
double
distance(const Point<dim> &x, const Point<dim> &a, const Point<dim> &b)
{
  const Tensor<1, dim> ab = b - a;
  const double length     = ab.norm_square();
  const double along =
    length > 0 ? std::clamp((x - a) * ab / length, 0., 1.) : 0.;
  return x.distance(a + along * ab);
}


double
distance(const Point<2> &x, const Simplex<2> &segment)
{
  return distance(x, segment[0], segment[1]);
}


/** Above the triangle the distance from its plane, else from its sides. */
double
distance(const Point<3> &x, const Simplex<3> &triangle)
{
  const auto &[a, b, c]     = triangle;
  const Tensor<1, 3> normal = cross_product_3d(b - a, c - a);
  bool above                = normal.norm() > 0;
  double nearest            = std::numeric_limits<double>::max();
  for (unsigned int i = 0; i < 3; ++i)
    {
      const auto &p = triangle[i], &q = triangle[(i + 1) % 3];
      above   = above && cross_product_3d(normal, q - p) * (x - p) >= 0;
      nearest = std::min(nearest, distance(x, p, q));
    }
  return above ? std::abs(normal * (x - a)) / normal.norm() : nearest;
}


/** A face as simplices between its nodes and its middle. */
template <int dim>
std::vector<Simplex<dim>>
simplices_of_face(const Body<dim> &body, const CellFace &face)
{
  const auto nodes = body.mesh.node_positions(face.first);
  Point<dim> middle;
  for (unsigned int d = 0; d < dim; ++d)
    middle[d] = d == face.second / 2 ? face.second % 2 : 0.5;
  const auto center = point_of_element(nodes, middle);

  // Each line of the face has two halves.
  std::vector<Simplex<dim>> simplices;
  for (unsigned int node = GeometryInfo<dim>::vertices_per_cell;
       node < nodes.size();
       ++node)
    if (node_is_on_face<dim>(node, face.second))
      {
        for (const unsigned int end : vertices_of_node<dim>(node))
          if constexpr (dim == 3)
            simplices.push_back({{nodes[end], nodes[node], center}});
          else
            simplices.push_back({{nodes[end], nodes[node]}});
      }
  return simplices;
}
} // namespace


template <int dim>
Neighborhood<dim>::Neighborhood(const Body<dim> &body,
                                const std::set<CellFace> &faces,
                                const double width)
  : width(width)
{
  std::vector<std::pair<BoundingBox<dim>, unsigned int>> boxes;
  for (const auto &face : faces)
    for (const auto &simplex : simplices_of_face(body, face))
      {
        BoundingBox<dim> box(
          std::vector<Point<dim>>(simplex.begin(), simplex.end()));
        box.extend(width);
        boxes.emplace_back(box, simplices.size());
        simplices.push_back(simplex);
      }
  tree = pack_rtree(boxes);
}



template <int dim>
bool
Neighborhood<dim>::contains(const Point<dim> &point) const
{
  namespace index = boost::geometry::index;
  for (const auto &candidate :
       tree | index::adaptors::queried(index::intersects(point)))
    if (distance(point, simplices[candidate.second]) <= width)
      return true;
  return false;
}



template class Neighborhood<2>;
template class Neighborhood<3>;
} // namespace Setsudan
