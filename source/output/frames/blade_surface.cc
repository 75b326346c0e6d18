// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/output/frames/blade_surface.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The cross section from one end of the blade around the edge to the other
 * one: distance behind the edge, and across the cut. */
std::vector<std::array<double, 2>>
outline(const BladeProfile &profile, const double shown)
{
  const double length                     = std::min(shown, profile.length);
  std::vector<std::array<double, 2>> half = {{{0., 0.}}};
  for (const auto &facet : profile.facets)
    if (facet.begin < length)
      half.push_back({{facet.begin, facet.half_thickness}});
  half.push_back({{length, profile.half_thickness(length)}});
  if (profile.facets.empty())
    return half;
  std::vector<std::array<double, 2>> whole;
  for (auto point = half.rbegin(); point != half.rend(); ++point)
    whole.push_back({{(*point)[0], -(*point)[1]}});
  whole.insert(whole.end(), half.begin(), half.end());
  return whole;
}
} // namespace


template <int dim>
VtuGrid
blade_surface(const BladeProfile &profile, const BladePlace<dim> &place)
{
  constexpr unsigned char vtk_line = 3, vtk_quadrilateral = 9;
  const auto section  = outline(profile, place.length);
  const auto n_points = static_cast<std::int32_t>(place.edge.size());
  std::vector<double> points;
  for (const auto &[behind, across] : section)
    for (const auto &of_edge : place.edge)
      {
        const Point<dim> point =
          of_edge - behind * place.direction + across * place.normal;
        for (unsigned int c = 0; c < 3; ++c)
          points.push_back(c < dim ? point[c % dim] : 0.);
      }
  VtuGrid grid{dim == 3 ? vtk_quadrilateral : vtk_line,
               dim == 3 ? 4 : 2,
               std::move(points),
               {},
               {},
               {},
               {}};
  const auto n = static_cast<std::int32_t>(section.size());
  for (std::int32_t i = 0; i + 1 < n; ++i)
    if constexpr (dim == 3)
      for (std::int32_t j = 0; j + 1 < n_points; ++j)
        {
          const std::int32_t first = n_points * i + j;
          grid.connectivity.insert(
            grid.connectivity.end(),
            {first, first + 1, first + n_points + 1, first + n_points});
        }
    else
      grid.connectivity.insert(grid.connectivity.end(), {i, i + 1});
  return grid;
}



template VtuGrid
blade_surface(const BladeProfile &, const BladePlace<2> &);
template VtuGrid
blade_surface(const BladeProfile &, const BladePlace<3> &);
} // namespace Setsudan
