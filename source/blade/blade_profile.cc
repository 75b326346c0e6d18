// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/numbers.h>

#include <setsudan/blade/blade_profile.h>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
namespace
{
// A blade loses energy at every edge of its shoulder, all in all in inverse
// proportion to their number.
constexpr unsigned int n_shoulder_facets = 64;
// Within 0.2 % of the circle. What presses across loses nothing at an edge.
constexpr unsigned int n_wire_facets = 48;
} // namespace


BladeProfile
BladeProfile::wedge(const double angle,
                    const double thickness,
                    const double radius)
{
  const double half_angle = angle / 2 * dealii::numbers::PI / 180;
  // The flank ends where the arc begins.
  const double flank_height =
    thickness / 2 - radius * (1 - std::cos(half_angle));
  const double flank_length = flank_height / std::tan(half_angle);
  const double center       = flank_length + radius * std::sin(half_angle);
  std::vector<std::pair<double, double>> points = {{0., 0.}};
  if (radius > 0)
    for (unsigned int k = 0; k < n_shoulder_facets; ++k)
      {
        const double turned = half_angle * (1 - double(k) / n_shoulder_facets);
        points.emplace_back(center - radius * std::sin(turned),
                            thickness / 2 - radius * (1 - std::cos(turned)));
      }
  points.emplace_back(center, thickness / 2);
  return polygon(points);
}



BladeProfile
BladeProfile::polygon(const std::vector<std::pair<double, double>> &points)
{
  BladeProfile profile;
  for (unsigned int k = 0; k + 1 < points.size(); ++k)
    {
      const auto &[s, h]     = points[k];
      const auto &[end, top] = points[k + 1];
      profile.facets.push_back({s, h, (top - h) / (end - s)});
    }
  profile.facets.push_back({points.back().first, points.back().second, 0.});
  return profile;
}



BladeProfile
BladeProfile::wire(const double diameter)
{
  const double radius = diameter / 2;
  std::vector<std::pair<double, double>> points;
  for (unsigned int k = 0; k <= n_wire_facets; ++k)
    {
      const double turned = k * dealii::numbers::PI / n_wire_facets;
      points.emplace_back(radius * (1 - std::cos(turned)),
                          radius * std::sin(turned));
    }
  BladeProfile profile = polygon(points);
  // There is no shank behind the last facet.
  profile.facets.pop_back();
  profile.length         = diameter;
  profile.presses_across = true;
  return profile;
}



void
BladeProfile::end_at(const double height)
{
  const double thick = half_thickness(height);
  facets.push_back({height, thick, -1.});
  length = height + thick;
}



unsigned int
BladeProfile::facet_at(const double s) const
{
  const auto behind = std::upper_bound(
    facets.begin(), facets.end(), s, [](const double at, const Facet &facet) {
      return at < facet.begin;
    });
  return std::max<long>(behind - facets.begin(), 1) - 1;
}



double
BladeProfile::half_thickness(const double s) const
{
  if (facets.empty())
    return 0;
  const Facet &facet = facets[facet_at(s)];
  return facet.half_thickness + facet.slope * (s - facet.begin);
}



double
BladeProfile::thickness() const
{
  double largest = 0;
  for (const auto &facet : facets)
    largest = std::max(largest, 2 * facet.half_thickness);
  return largest;
}



bool
BladeProfile::is_tip(const unsigned int k) const
{
  return (k == 0 && facets[k].slope > 0) ||
         (k + 1 == facets.size() && facets[k].slope < 0);
}
} // namespace Setsudan
