// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/material_axes.h>

#include <cmath>

namespace Setsudan
{
using namespace dealii;

namespace
{
// Vectors of decimal fractions are hardly ever at right angles to the last
// digit.
constexpr double most_askew = 1e-3;
} // namespace


std::optional<MaterialAxes>
find_axes(const std::array<double, 3> &first,
          const std::array<double, 3> &second)
{
  Tensor<1, 3> one, two;
  for (unsigned int d = 0; d < 3; ++d)
    {
      one[d] = first[d];
      two[d] = second[d];
    }
  if (!(one.norm() > 0 && two.norm() > 0))
    return {};
  one /= one.norm();
  two /= two.norm();
  const double askew = one * two;
  if (!(std::abs(askew) <= most_askew))
    return {};
  two -= askew * one;
  two /= two.norm();
  return MaterialAxes{{one, two, cross_product_3d(one, two)}};
}
} // namespace Setsudan
