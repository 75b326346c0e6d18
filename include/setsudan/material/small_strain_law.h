// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/symmetric_tensor.h>

#include <setsudan/material/constitutive_law.h>
#include <setsudan/material/material.h>

namespace Setsudan
{
/** What a law of small strain answers to a strain and a change of volume. */
struct SmallStrainResponse
{
  /** [force/area] */
  dealii::SymmetricTensor<2, 3> stress;
  /** Its derivative by the strain while the change of volume stays
   * [force/area]. */
  dealii::SymmetricTensor<4, 3> tangent;
  /** The part of it, along the unit tensor, that the change of volume gives
   * while the strain stays; and its derivative by that [force/area]. */
  double mean_stress = 0;
  double lambda      = 0;
  Energy energy;
};

/**
 * A law between stress and small strain. The change of volume is handed over
 * apart from the strain, whose trace it usually is, since it may be projected
 * (see Dilatation).
 */
class SmallStrainLaw : public ConstitutiveLaw
{
public:
  virtual SmallStrainResponse
  respond(const dealii::SymmetricTensor<2, 3> &strain,
          const double dilatation,
          const History &history) const = 0;

  const SmallStrainLaw *
  small_strain() const final
  {
    return this;
  }

  /** respond(), of the symmetric part of the gradient. */
  MaterialResponse
  evaluate(const dealii::Tensor<2, 3> &gradient,
           const History &history,
           const bool needs_tangent) const final;
};

/** Hooke's law. */
class LinearElasticity : public SmallStrainLaw
{
public:
  explicit LinearElasticity(const Hooke &hooke);

  bool
  is_linear() const override
  {
    return true;
  }

  SmallStrainResponse
  respond(const dealii::SymmetricTensor<2, 3> &strain,
          const double dilatation,
          const History &history) const override;

private:
  const Hooke hooke;
};
} // namespace Setsudan
