// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/material/hyperelastic_law.h>
#include <setsudan/material/small_strain_law.h>

#include <memory>
#include <string>

namespace Setsudan
{
/**
 * A law of small strain for finite strain: it is given the logarithmic strain
 *   E = 1/2 ln C,   C = F^T F,
 * of which the trace is ln J, so that what keeps its trace keeps the volume;
 * its stress is taken for what is conjugate to that. So energies, symmetric
 * tangents and internal variables are those of the law (Miehe, Apel and
 * Lambrecht 2002, Computer Methods in Applied Mechanics and Engineering 191,
 * 5383-5425). Hooke's law gives the energy of Hencky. Where all directions turn
 * together the strain of a dashpot, or of plastic flow, turns with them.
 */
class LogarithmicStrain : public ConstitutiveLaw
{
public:
  explicit LogarithmicStrain(const std::shared_ptr<const SmallStrainLaw> &law);

  std::string
  name() const override;

  const LogarithmicStrain *
  logarithmic() const override
  {
    return this;
  }

  bool
  is_plastic() const override
  {
    return law->is_plastic();
  }

  bool
  is_viscous() const override
  {
    return law->is_viscous();
  }

  unsigned int
  n_internal() const override
  {
    return law->n_internal();
  }

  void
  initialize(const dealii::ArrayView<double> &internal) const override
  {
    law->initialize(internal);
  }

  /** What the law answers where the volume may be projected. */
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
  Response
  respond(const dealii::SymmetricTensor<2, 3> &C,
          const double volume,
          const History &history,
          const bool needs_tangent) const;

  MaterialResponse
  evaluate(const dealii::Tensor<2, 3> &gradient,
           const History &history,
           const bool needs_tangent) const override;

private:
  const std::shared_ptr<const SmallStrainLaw> law;
};
} // namespace Setsudan
