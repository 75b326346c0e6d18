// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>

#include <setsudan/cut/seam/surface_strips.h>
#include <setsudan/mesh/geometry.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>

namespace Setsudan
{
using namespace dealii;

namespace
{
template <int dim>
Point<dim>
point_on_face(const unsigned int face, const Point<dim - 1> &face_point)
{
  Point<dim> point;
  for (unsigned int d = 0, k = 0; d < dim; ++d)
    point[d] = d == face / 2 ? face % 2 : face_point[k++];
  return point;
}



/** Where the blade enters a surface. */
template <int dim>
double
entry_of_surface(const Body<dim> &body,
                 const CutSurface<dim> &surface,
                 const BladeEdge<dim> &edge)
{
  double entry = std::numeric_limits<double>::max();
  for (const auto &face : surface)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      if (node_is_on_face<dim>(node, face.minus.second))
        entry = std::min(
          entry, edge.travel(body.mesh.node_position(face.minus.first, node)));
  return entry;
}
} // namespace


template <int dim>
std::vector<SurfaceStrip>
strips_of_surface(const Body<dim> &body,
                  const CutSurface<dim> &surface,
                  const BladeEdge<dim> &edge,
                  const unsigned int n_cells_on_line)
{
  const unsigned int n_on_line = 4 * n_cells_on_line;
  const unsigned int n_parts   = Utilities::pow(n_on_line, dim - 1);
  const double entry           = entry_of_surface(body, surface, edge);
  const QGauss<dim - 1> gauss(2);
  std::vector<SurfaceStrip> strips;
  for (unsigned int f = 0; f < surface.size(); ++f)
    {
      const auto &[cell, face] = surface[f].minus;
      const auto nodes         = body.mesh.node_positions(cell);
      for (unsigned int part = 0; part < n_parts; ++part)
        {
          const auto in_part = [&, face = face](const Point<dim - 1> &point) {
            Point<dim - 1> face_point;
            for (unsigned int d = 0, rest = part; d < dim - 1;
                 ++d, rest /= n_on_line)
              face_point[d] = (rest % n_on_line + point[d]) / n_on_line;
            return point_on_face<dim>(face, face_point);
          };
          SurfaceStrip strip{std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::lowest(),
                             0,
                             f};
          for (const unsigned int v : GeometryInfo<dim - 1>::vertex_indices())
            {
              const auto corner =
                in_part(GeometryInfo<dim - 1>::unit_cell_vertex(v));
              const double depth =
                edge.travel(point_of_element(nodes, corner)) - entry;
              strip.begin = std::min(strip.begin, depth);
              strip.end   = std::max(strip.end, depth);
            }
          for (unsigned int q = 0; q < gauss.size(); ++q)
            strip.area +=
              gauss.weight(q) / n_parts *
              area_element_of_face(nodes, face, in_part(gauss.point(q)));
          strips.push_back(strip);
        }
    }
  return strips;
}



AreaBehindEdge::AreaBehindEdge(const std::vector<SurfaceStrip> &strips)
{
  // How the area grows per depth changes where strips begin and end; a strip
  // across the way counts at once.
  std::map<double, std::array<double, 2>> changes;
  for (const auto &strip : strips)
    if (strip.end > strip.begin)
      {
        const double rate = strip.area / (strip.end - strip.begin);
        changes[strip.begin][0] += rate;
        changes[strip.end][0] -= rate;
      }
    else
      changes[strip.begin][1] += strip.area;
  double rate = 0, area = 0, last = 0;
  for (const auto &[depth, change] : changes)
    {
      area += rate * (depth - last);
      points.push_back({{area, depth}});
      rate += change[0];
      area += change[1];
      points.push_back({{area, depth}});
      last = depth;
    }
}



namespace
{
/** Between points of two ascending coordinates, one of them as a function of
 * the other. */
double
interpolate(const std::vector<std::array<double, 2>> &points,
            const unsigned int from,
            const double at)
{
  const auto behind =
    std::find_if(points.begin(), points.end(), [&](const auto &point) {
      return point[from] >= at;
    });
  if (behind == points.begin())
    return points.front()[1 - from];
  if (behind == points.end())
    return points.back()[1 - from];
  const auto &before = *std::prev(behind);
  const double part  = (at - before[from]) / ((*behind)[from] - before[from]);
  return before[1 - from] + part * ((*behind)[1 - from] - before[1 - from]);
}
} // namespace


double
AreaBehindEdge::depth_of(const double part) const
{
  return interpolate(points, 0, part * points.back()[0]);
}



double
AreaBehindEdge::part_at(const double depth) const
{
  return interpolate(points, 1, depth) / points.back()[0];
}



template std::vector<SurfaceStrip>
strips_of_surface(const Body<2> &,
                  const CutSurface<2> &,
                  const BladeEdge<2> &,
                  const unsigned int);
template std::vector<SurfaceStrip>
strips_of_surface(const Body<3> &,
                  const CutSurface<3> &,
                  const BladeEdge<3> &,
                  const unsigned int);
} // namespace Setsudan
