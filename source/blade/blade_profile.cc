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
  const auto point_of_arc   = [&](const double turned) {
    return std::make_pair(center - radius * std::sin(turned),
                          thickness / 2 - radius * (1 - std::cos(turned)));
  };
  BladeProfile profile;
  profile.facets.push_back({0., 0., std::tan(half_angle)});
  if (radius > 0)
    for (unsigned int k = 0; k < n_shoulder_facets; ++k)
      {
        const auto turned = [&](const unsigned int step) {
          return half_angle * (1 - double(step) / n_shoulder_facets);
        };
        const auto [s, h]       = point_of_arc(turned(k));
        const auto [s_end, end] = point_of_arc(turned(k + 1));
        profile.facets.push_back({s, h, (end - h) / (s_end - s)});
      }
  profile.facets.push_back({center, thickness / 2, 0.});
  return profile;
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
} // namespace Setsudan
