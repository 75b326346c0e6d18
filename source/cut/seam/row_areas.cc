// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>

#include <setsudan/cut/seam/row_areas.h>
#include <setsudan/mesh/geometry.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** A part of a face: its area, and from where to where the blade travels along
 * it, counted from where the blade enters the surface. */
struct Strip
{
  double begin;
  double end;
  double area;
};



template <int dim>
Point<dim>
point_on_face(const unsigned int face, const Point<dim - 1> &face_point)
{
  Point<dim> point;
  for (unsigned int d = 0, k = 0; d < dim; ++d)
    point[d] = d == face / 2 ? face % 2 : face_point[k++];
  return point;
}



/** A face in four parts to each line, since it may be curved or lie askew to
 * the blade. */
template <int dim>
std::vector<Strip>
strips_of_face(const ElementNodes<dim> &nodes,
               const unsigned int face,
               const BladeEdge<dim> &edge,
               const double entry)
{
  constexpr unsigned int n_per_line = 4;
  constexpr unsigned int n_parts    = Utilities::pow(n_per_line, dim - 1);
  const QGauss<dim - 1> gauss(2);
  std::vector<Strip> strips;
  for (unsigned int part = 0; part < n_parts; ++part)
    {
      const auto in_part = [&](const Point<dim - 1> &point) {
        Point<dim - 1> face_point;
        for (unsigned int d = 0, rest = part; d < dim - 1;
             ++d, rest /= n_per_line)
          face_point[d] = (rest % n_per_line + point[d]) / n_per_line;
        return point_on_face<dim>(face, face_point);
      };
      Strip strip{std::numeric_limits<double>::max(),
                  std::numeric_limits<double>::lowest(),
                  0};
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
  return strips;
}



/** Share a strip's area out to the rows in front of which it lies. */
void
share_out(const Strip &strip,
          const double toughness,
          const std::vector<Row> &rows,
          std::vector<RowArea> &areas)
{
  const auto begins_behind = [](const double depth, const Row &row) {
    return depth < row.depth;
  };
  const double length = strip.end - strip.begin;
  // A little off, round-off must not give a strip to the row before it.
  const double inside = strip.begin + 1e-10 * length;
  auto row =
    std::upper_bound(rows.begin() + 1, rows.end(), inside, begins_behind) -
    rows.begin() - 1;
  double begin = strip.begin;
  for (bool is_last = false; !is_last; ++row)
    {
      is_last = row + 1 == static_cast<std::ptrdiff_t>(rows.size()) ||
                rows[row + 1].depth >= strip.end - 1e-10 * length;
      const double end = is_last ? strip.end : rows[row + 1].depth;
      const double area =
        length > 0 ? strip.area * (end - begin) / length : strip.area;
      areas[row].area += area;
      areas[row].energy += area * toughness;
      begin = end;
    }
}
} // namespace


template <int dim>
std::vector<RowArea>
row_areas(const Body<dim> &body,
          const MaterialParameters<dim> &materials,
          const CutSurface<dim> &surface,
          const BladeEdge<dim> &edge,
          const std::vector<Row> &rows)
{
  double entry = std::numeric_limits<double>::max();
  for (const auto &face : surface)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      if (node_is_on_face<dim>(node, face.minus.second))
        entry = std::min(
          entry, edge.travel(body.mesh.node_position(face.minus.first, node)));

  std::vector<RowArea> areas(rows.size());
  for (const auto &face : surface)
    {
      const auto &[cell, f] = face.minus;
      const double toughness =
        std::min(materials.of_element(cell).toughness,
                 materials.of_element(face.plus.first).toughness);
      for (const auto &strip :
           strips_of_face(body.mesh.node_positions(cell), f, edge, entry))
        share_out(strip, toughness, rows, areas);
    }
  return areas;
}



template std::vector<RowArea>
row_areas(const Body<2> &,
          const MaterialParameters<2> &,
          const CutSurface<2> &,
          const BladeEdge<2> &,
          const std::vector<Row> &);
template std::vector<RowArea>
row_areas(const Body<3> &,
          const MaterialParameters<3> &,
          const CutSurface<3> &,
          const BladeEdge<3> &,
          const std::vector<Row> &);
} // namespace Setsudan
