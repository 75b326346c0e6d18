// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/tensor.h>

#include <array>
#include <optional>

namespace Setsudan
{
/** The axes of a material: unit vectors at right angles, right-handed. */
using MaterialAxes = std::array<dealii::Tensor<1, 3>, 3>;

/** The axes of which two vectors give the first and the second; where these are
 * off a right angle by up to 1e-3 the second one is turned.
 *
 * @return nothing for other vectors. */
std::optional<MaterialAxes>
find_axes(const std::array<double, 3> &first,
          const std::array<double, 3> &second);
} // namespace Setsudan
