// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/numbers.h>

#include <setsudan/blade/blade.h>
#include <setsudan/parameters/lists.h>

#include <algorithm>
#include <cmath>
#include <limits>

// The blade's body and its edge.

namespace Setsudan
{
using namespace dealii;

namespace
{
BladeProfile
read_profile(const Parameters &parameters)
{
  std::vector<std::pair<double, double>> points;
  bool is_profile = true;
  for (const auto &[distance, half_thickness] :
       split_items(parameters.text("Blade", "Profile"), ','))
    {
      std::vector<double> s, h;
      is_profile = is_profile && parse_numbers(distance, s) && s.size() == 1 &&
                   parse_numbers(half_thickness, h) && h.size() == 1;
      if (!is_profile)
        break;
      const auto &[last, top] =
        points.empty() ? std::make_pair(-1., 0.) : points.back();
      // It is blunt nowhere, and grows thinner nowhere.
      is_profile = points.empty() ? s[0] == 0 && h[0] == 0
                                  : s[0] > last && h[0] >= top && h[0] > 0;
      points.emplace_back(s[0], h[0]);
    }
  parameters.require(is_profile && points.size() > 1,
                     "Blade",
                     "Profile",
                     "two or more 'distance : half thickness' that begin with "
                     "0 : 0, of ascending distances, and half thicknesses that "
                     "are more than 0 from the second one on and do not fall");
  return BladeProfile::polygon(points);
}

BladeProfile
read_wedge(const Parameters &parameters, const double thickness)
{
  const double angle  = parameters.number("Blade", "Wedge angle");
  const double radius = parameters.number("Blade", "Shoulder radius");
  parameters.require(angle > 0 && angle < 180,
                     "Blade",
                     "Wedge angle",
                     "an angle of more than 0 and less than 180 degrees");
  const double largest =
    thickness / 2 / (1 - std::cos(angle / 2 * numbers::PI / 180));
  parameters.require(radius >= 0 && radius <= largest,
                     "Blade",
                     "Shoulder radius",
                     "a length from 0 to " + std::to_string(largest) +
                       ", with which the flanks have no length left");
  return BladeProfile::wedge(angle, thickness, radius);
}
} // namespace


template <int dim>
void
BladeParameters<dim>::read_shape(const Parameters &parameters)
{
  const std::string shape = parameters.text("Blade", "Shape");
  sliding.is_guided       = parameters.text("Blade", "Guide") == "fixed";
  parameters.require(shape != "line" || sliding.is_guided,
                     "Blade",
                     "Guide",
                     "fixed where Blade/Shape is line");
  parameters.require(sliding.adhesion == 0 || sliding.is_guided,
                     "Blade",
                     "Adhesion",
                     "0 where Blade/Guide is free");
  if (shape == "line")
    return;
  parameters.require(
    travels, "Blade", "Shape", "line where Blade/Drive is force");
  if (shape == "profile")
    {
      profile = read_profile(parameters);
      read_height(parameters);
      return;
    }
  parameters.require(
    thickness > 0, "Blade", "Thickness", "more than 0, for a " + shape);
  profile = shape == "wire" ? BladeProfile::wire(thickness)
                            : read_wedge(parameters, thickness);
  read_height(parameters);
}



template <int dim>
void
BladeParameters<dim>::read_height(const Parameters &parameters)
{
  const double height  = parameters.number("Blade", "Height");
  const double tapered = profile.facets.back().begin;
  parameters.require(height == 0 || !profile.presses_across,
                     "Blade",
                     "Height",
                     "0 where Blade/Shape is wire");
  parameters.require(height == 0 || height > tapered,
                     "Blade",
                     "Height",
                     "0, or more than " + short_text(tapered) +
                       ", where the shank begins");
  if (height > 0)
    profile.end_at(height);
}



template <int dim>
void
BladeParameters<dim>::read_edge_points(const Parameters &parameters)
{
  const std::string text = parameters.text("Blade", "Edge points");
  const auto require     = [&](const bool holds, const std::string &allowed) {
    parameters.require(holds, "Blade", "Edge points", allowed);
  };
  double foremost = std::numeric_limits<double>::max();
  for (const auto &[position, setback] : split_items(text, ','))
    {
      std::vector<double> values;
      require(parse_numbers(position + "," + setback, values) &&
                values.size() == 2,
              "points 'position : distance behind the foremost one', separated "
              "by ','");
      require(edge_points.empty() || values[0] > edge_points.back().position,
              "positions that ascend");
      edge_points.push_back({values[0], values[1]});
      foremost = std::min(foremost, values[1]);
    }
  require(edge_points.empty() || edge_points.size() > 1, "two points or more");
  require(edge_points.empty() || dim == 3,
          "nothing in 2D, where the edge is a point");
  for (auto &point : edge_points)
    point.setback -= foremost;
}



#define INSTANTIATE(dim)                                               \
  template void BladeParameters<dim>::read_shape(const Parameters &);  \
  template void BladeParameters<dim>::read_height(const Parameters &); \
  template void BladeParameters<dim>::read_edge_points(const Parameters &);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
