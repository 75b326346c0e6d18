// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/material/small_strain_law.h>

#include <string>

namespace Setsudan
{
/** How the limit of a plastic material grows with its plastic strain. */
struct Hardening
{
  /** By how much the yield stress rises with the accumulated plastic strain
   * [force/area]. */
  double isotropic = 0;
  /** By how much the center of the elastic range moves with the plastic strain
   * of a bar, 2/3 of it times the plastic strain tensor [force/area]. */
  double kinematic = 0;
};

/**
 * Small strain plasticity of von Mises (J2): Hooke's law between the stress and
 * the elastic part of the strain, and an associated flow under which
 *   |dev stress - 2/3 H_kin plastic strain|
 *     <= sqrt(2/3) (yield stress + H_iso accumulated plastic strain),
 * where the accumulated strain is that of a bar. A state follows from the last
 * accepted one by the radial return of Simo and Hughes (1998, Computational
 * Inelasticity, box 3.2), an implicit Euler step: it is the minimum of stored
 * energy and plastic work, from which stress and the consistent tangent are
 * derived, both symmetric.
 *
 * Internal variables: the plastic strain xx, yy, zz, xy, yz, zx and the
 * accumulated one.
 */
class J2Plasticity : public SmallStrainLaw
{
public:
  J2Plasticity(const Hooke &hooke,
               const double yield_stress,
               const Hardening &hardening);

  std::string
  name() const override
  {
    return "J2 plasticity";
  }

  bool
  is_plastic() const override
  {
    return true;
  }

  unsigned int
  n_internal() const override;

  void
  initialize(const dealii::ArrayView<double> &internal) const override;

  SmallStrainResponse
  respond(const dealii::SymmetricTensor<2, 3> &strain,
          const double dilatation,
          const History &history) const override;

private:
  const Hooke hooke;
  const double yield_stress;
  const Hardening hardening;
};
} // namespace Setsudan
