// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/parameters/parameters.h>

namespace Setsudan
{
/** How toughness and limits of stress depend on the speed v of the front: times
 * 1 + (v / v0)^n. */
struct RateLaw
{
  /** n; 0 if it does not. */
  double exponent;
  /** v0 [length/time]. */
  double speed;

  static void
  declare(dealii::ParameterHandler &handler);

  explicit RateLaw(const Parameters &parameters);

  bool
  is_active() const
  {
    return exponent > 0;
  }

  /** What they are multiplied with. */
  double
  factor(const double front_speed) const;
};
} // namespace Setsudan
