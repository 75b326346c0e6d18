// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/quadratic.h>

#include <cmath>

namespace Setsudan
{
std::optional<double>
Quadratic::first_root(const double begin, const double end) const
{
  // About the beginning, where the travel is small beside what it was.
  const double value     = (*this)(begin);
  const double slope     = c[1] + 2 * c[2] * begin;
  const double curvature = c[2];
  if (value >= 0)
    return begin;
  const double discriminant = slope * slope - 4 * curvature * value;
  if (discriminant < 0)
    return {};
  // Of the two, without cancellation.
  const double q =
    -0.5 * (slope + std::copysign(std::sqrt(discriminant), slope));
  std::optional<double> first;
  for (const double root : {q / curvature, value / q})
    if (std::isfinite(root) && root > 0 && begin + root <= end &&
        (!first || begin + root < *first))
      first = begin + root;
  return first;
}
} // namespace Setsudan
