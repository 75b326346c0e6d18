// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/seam/row_areas.h>

#include <algorithm>
#include <cstddef>

namespace Setsudan
{
namespace
{
/** Share a strip's area out to the rows in front of which it lies. */
void
share_out(const SurfaceStrip &strip,
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
row_areas(const std::vector<SurfaceStrip> &strips,
          const Body<dim> &body,
          const CutSurface<dim> &surface,
          const MaterialParameters<dim> &materials,
          const std::vector<Row> &rows)
{
  std::vector<double> toughness;
  const auto normals = areas_of_faces(body, surface);
  for (unsigned int f = 0; f < surface.size(); ++f)
    {
      const auto normal = normals[f] / normals[f].norm();
      const auto across = [&](const unsigned int element) {
        return materials.of_element(element).toughness.across(normal);
      };
      toughness.push_back(std::min(across(surface[f].minus.first),
                                   across(surface[f].plus.first)));
    }
  std::vector<RowArea> areas(rows.size());
  for (const auto &strip : strips)
    share_out(strip, toughness[strip.face], rows, areas);
  return areas;
}



template std::vector<RowArea>
row_areas(const std::vector<SurfaceStrip> &,
          const Body<2> &,
          const CutSurface<2> &,
          const MaterialParameters<2> &,
          const std::vector<Row> &);
template std::vector<RowArea>
row_areas(const std::vector<SurfaceStrip> &,
          const Body<3> &,
          const CutSurface<3> &,
          const MaterialParameters<3> &,
          const std::vector<Row> &);
} // namespace Setsudan
