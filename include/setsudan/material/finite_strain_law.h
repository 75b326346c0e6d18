// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/material/hyperelastic_law.h>

namespace Setsudan
{
/**
 * A law of finite strain with internal variables. The volume is handed over
 * apart from C, of which it usually is sqrt(det C), since it may be projected
 * (see MixedCell).
 */
class FiniteStrainLaw : public ConstitutiveLaw
{
public:
  /** What the law answers to C and a volume. */
  struct Response
  {
    /** Without the mean stress below; its value is not set. */
    StrainEnergy distortion;
    /** The derivative of the energy by the volume, and its derivative
     * [force/area]. */
    double mean_stress;
    double stiffness;
    Energy energy;
  };

  /** @param volume over that at rest, greater than 0. */
  virtual Response
  respond(const dealii::SymmetricTensor<2, 3> &C,
          const double volume,
          const History &history,
          const bool needs_tangent) const = 0;

  const FiniteStrainLaw *
  finite_strain() const final
  {
    return this;
  }

  /** respond(), with the volume of C; where that is not positive the energy is
   * infinite, and nothing else is set. */
  MaterialResponse
  evaluate(const dealii::Tensor<2, 3> &gradient,
           const History &history,
           const bool needs_tangent) const final;
};
} // namespace Setsudan
