// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/rate_law.h>

#include <cmath>

namespace Setsudan
{
using namespace dealii;

void
RateLaw::declare(ParameterHandler &handler)
{
  Setsudan::declare(
    handler,
    "Material",
    "Rate exponent",
    "0",
    Patterns::Double(),
    "n, with which a front of speed v needs the toughness, or the limit of "
    "stress, times 1 + (v/v0)^n, under a blade that travels; 0 if speed does "
    "not matter [-].");
  Setsudan::declare(handler,
                    "Material",
                    "Rate speed",
                    "1",
                    Patterns::Double(),
                    "v0 in that, more than 0 [length/time].");
}



RateLaw::RateLaw(const Parameters &parameters)
  : exponent(parameters.number("Material", "Rate exponent"))
  , speed(parameters.number("Material", "Rate speed"))
{
  parameters.require(exponent >= 0,
                     "Material",
                     "Rate exponent",
                     "a number that is not negative");
  parameters.require(
    speed > 0, "Material", "Rate speed", "a speed greater than 0");
}



double
RateLaw::factor(const double front_speed) const
{
  return is_active() ? 1 + std::pow(front_speed / speed, exponent) : 1.;
}
} // namespace Setsudan
