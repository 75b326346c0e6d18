// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/symmetric_tensor.h>

namespace Setsudan
{
/**
 * Hooke's law of an isotropic body (equation 11 of Kakefuda et al. 1996 with
 * its typing errors mended). In 2D the strain is plane.
 */
class Hooke
{
public:
  Hooke(const double youngs_modulus, const double poissons_ratio);

  /**
   * The stress of a strain; the out-of-plane stress of plane strain is part of
   * it, since the maximum shear may lie across the plane.
   */
  template <int dim>
  dealii::SymmetricTensor<2, 3>
  stress(const dealii::SymmetricTensor<2, dim> &strain) const;

  /** The same where the change of volume is not the strain's trace (see
   * Dilatation). */
  template <int dim>
  dealii::SymmetricTensor<2, 3>
  stress(const dealii::SymmetricTensor<2, dim> &strain,
         const double dilatation) const;

  double
  youngs_modulus() const
  {
    return mu * (3 * lambda + 2 * mu) / (lambda + mu);
  }

  double
  poissons_ratio() const
  {
    return lambda / (2 * (lambda + mu));
  }

  /** Lamé's constants [force/area]. */
  const double lambda;
  const double mu;
};

/** Tresca's measure (s1 - s3) / 2 of the principal stresses s1 >= s2 >= s3. */
double
maximum_shear(const dealii::SymmetricTensor<2, 3> &stress);
} // namespace Setsudan
