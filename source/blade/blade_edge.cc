// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/numbers.h>

#include <setsudan/blade/blade_edge.h>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

namespace
{
double
degrees_of_sine(const double sine)
{
  return std::asin(std::min(1., std::abs(sine))) * 180 / numbers::PI;
}

/** How far an edge is behind its foremost point, at a position. */
double
setback(const std::vector<EdgePoint> &points, const double position)
{
  if (points.empty())
    return 0;
  const auto next =
    std::upper_bound(points.begin(),
                     points.end(),
                     position,
                     [](const double at, const EdgePoint &point) {
                       return at < point.position;
                     });
  if (next == points.begin() || next == points.end())
    return (next == points.end() ? points.back() : points.front()).setback;
  const auto last = next - 1;
  return last->setback + (next->setback - last->setback) *
                           (position - last->position) /
                           (next->position - last->position);
}

/** The mean of the sine between a direction and faces. */
template <int dim>
double
mean_sine(const std::vector<Tensor<1, dim>> &areas,
          const Tensor<1, dim> &direction)
{
  double across = 0, sum = 0;
  for (const auto &area : areas)
    {
      across += std::abs(area * direction);
      sum += area.norm();
    }
  return sum > 0 ? across / sum : 0.;
}
} // namespace


template <int dim>
BladeEdge<dim>::BladeEdge(const std::vector<Tensor<1, dim>> &areas,
                          const Tensor<1, dim> &way,
                          const std::vector<EdgePoint> &points)
  : direction(way)
  , points(points)
{
  double area = 0;
  for (const auto &face : areas)
    {
      normal += face;
      area += face.norm();
    }
  is_planar = normal.norm() > 1e-6 * area;
  if (is_planar)
    normal /= normal.norm();
  // A direction that lies in the cut up to round-off stays as it is.
  const double out_of_plane = normal * way;
  if (is_planar && std::abs(out_of_plane) > 1e-12)
    {
      Tensor<1, dim> projected = way - out_of_plane * normal;
      if (projected.norm() > 1e-12)
        projected /= projected.norm();
      is_planar = projected.norm() > 0.5 &&
                  mean_sine(areas, projected) < mean_sine(areas, way);
      if (is_planar)
        {
          projection_angle = degrees_of_sine(out_of_plane);
          direction        = projected;
        }
    }
  angle_to_faces = degrees_of_sine(mean_sine(areas, direction));
  if constexpr (dim == 3)
    {
      // Any edge across the way, where the surface has no plane.
      Tensor<1, dim> tangent = cross_product_3d(normal, direction);
      for (unsigned int d = 0; d < dim && !is_planar; ++d)
        tangent[d] = 1 - std::abs(direction[d]);
      for (unsigned int d = 1; d < dim; ++d)
        // The first of equally near axes, whatever the round-off.
        if (std::abs(tangent[d]) > std::abs(tangent[axis]) + 1e-12)
          axis = d;
    }
}



template <int dim>
double
BladeEdge<dim>::travel(const Point<dim> &point) const
{
  return direction * Tensor<1, dim>(point) + setback(points, position(point));
}



template <int dim>
double
BladeEdge<dim>::position(const Point<dim> &point) const
{
  return dim == 2 ? 0. : point[axis];
}



namespace
{
/** Share a force equally among the nodes of one position on the edge: where an
 * earlier cut crosses, there is one on each side of it. */
void
share_equally(const double force,
              const unsigned int node,
              const std::vector<double> &nodes,
              std::vector<NodeShare> &shares)
{
  const double tolerance = 1e-10 * (nodes.back() - nodes.front());
  const auto begin =
    std::lower_bound(nodes.begin(), nodes.end(), nodes[node] - tolerance);
  const auto end =
    std::upper_bound(begin, nodes.end(), nodes[node] + tolerance);
  for (auto it = begin; it != end; ++it)
    shares.push_back({static_cast<unsigned int>(it - nodes.begin()),
                      force / static_cast<double>(end - begin)});
}
} // namespace



std::vector<NodeShare>
share_edge_loads(const std::vector<EdgeLoad> &loads,
                 const std::vector<double> &nodes)
{
  Assert(std::is_sorted(nodes.begin(), nodes.end()), ExcInternalError());
  std::vector<NodeShare> shares;
  for (const auto &[position, force] : loads)
    {
      const unsigned int after =
        std::lower_bound(nodes.begin(), nodes.end(), position) - nodes.begin();
      if (after == 0 || after == nodes.size())
        {
          share_equally(force, after == 0 ? 0 : after - 1, nodes, shares);
          continue;
        }
      const double lever =
        (position - nodes[after - 1]) / (nodes[after] - nodes[after - 1]);
      if (lever < 1)
        share_equally((1 - lever) * force, after - 1, nodes, shares);
      share_equally(lever * force, after, nodes, shares);
    }
  return shares;
}



template struct BladeEdge<2>;
template struct BladeEdge<3>;
} // namespace Setsudan
