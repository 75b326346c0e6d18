// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/symmetric_tensor.h>

#include <setsudan/material/material_axes.h>

#include <array>

namespace Setsudan
{
/**
 * What a material requires of a blade of sharpness 0, a shear limit or a
 * toughness: a number, or three that belong to the material's axes. Then a cut
 * with the unit normal n requires the sum of R_i (n . e_i)^2, that is R_i where
 * its normal is the axis e_i.
 */
class CutLimit
{
public:
  /** The same for all normals. */
  explicit CutLimit(const double limit);

  CutLimit(const std::array<double, 3> &limits, const MaterialAxes &axes);

  /** @param normal of length 1. */
  template <int dim>
  double
  across(const dealii::Tensor<1, dim> &normal) const;

  /** Over all normals, in 2D those in the plane. */
  double
  smallest(const unsigned int dim) const;

  /** Add a multiple of another limit. */
  void
  add(const double factor, const CutLimit &other);

private:
  /** R, of which across() is n . R n. */
  dealii::SymmetricTensor<2, 3> tensor;
  bool is_isotropic;
};
} // namespace Setsudan
