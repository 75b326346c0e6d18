// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/material/decoupled_law.h>
#include <setsudan/material/finite_strain_law.h>
#include <setsudan/material/viscoelasticity.h>

#include <memory>
#include <string>

namespace Setsudan
{
/**
 * A hyperelastic law of which parts of the distortion's energy W' relax: each
 * is that of a spring in series with a dashpot, whose deformation is divided by
 * the dashpot's, F Fv^-1. The dashpot flows along the stress of its spring,
 *   D = dev(stress) / (2 viscosity),  viscosity = shear modulus x time
 * (Reese and Govindjee 1998, International Journal of Solids and Structures 35,
 * 3455-3482). A step is an implicit Euler step in the principal logarithmic
 * strains of the spring: the minimum of what it stores and half of what the
 * dashpot turns into heat, so that its tangent is symmetric.
 *
 * Internal variables: what viscosity has turned into heat, and for each part
 * the change of Fv^-1 from that at rest.
 */
class FiniteViscoelasticity : public FiniteStrainLaw
{
public:
  /** @param law of sudden strains.
   * @param terms of its shear modulus. */
  FiniteViscoelasticity(const std::shared_ptr<const DecoupledLaw> &law,
                        const Hooke &at_once,
                        const Relaxation::Terms &terms);

  std::string
  name() const override;

  bool
  is_viscous() const override
  {
    return true;
  }

  unsigned int
  n_internal() const override;

  void
  initialize(const dealii::ArrayView<double> &internal) const override;

  Response
  respond(const dealii::SymmetricTensor<2, 3> &C,
          const double volume,
          const History &history,
          const bool needs_tangent) const override;

private:
  const std::shared_ptr<const DecoupledLaw> law;
  const double mu;
  const Relaxation::Terms terms;
  /** Of the shear modulus. */
  const double lasting_part;
};
} // namespace Setsudan
