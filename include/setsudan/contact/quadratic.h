// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>

namespace Setsudan
{
/** The quadratic function c[0] + c[1] p + c[2] p^2. */
struct Quadratic
{
  std::array<double, 3> c{};

  double
  operator()(const double p) const
  {
    return c[0] + p * (c[1] + p * c[2]);
  }

  /** The smallest root between two points, the first of which is one if the
   * function is not negative there. */
  std::optional<double>
  first_root(const double begin, const double end) const;
};
} // namespace Setsudan
