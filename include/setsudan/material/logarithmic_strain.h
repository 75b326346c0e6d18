// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/material/finite_strain_law.h>
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
class LogarithmicStrain : public FiniteStrainLaw
{
public:
  explicit LogarithmicStrain(const std::shared_ptr<const SmallStrainLaw> &law);

  std::string
  name() const override;

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

  Response
  respond(const dealii::SymmetricTensor<2, 3> &C,
          const double volume,
          const History &history,
          const bool needs_tangent) const override;

private:
  const std::shared_ptr<const SmallStrainLaw> law;
};
} // namespace Setsudan
