// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/symmetric_tensor.h>

#include <setsudan/material/constitutive_law.h>
#include <setsudan/material/material.h>
#include <setsudan/material/volumetric_energy.h>

#include <optional>
#include <string>

namespace Setsudan
{
/** What a strain energy W(C) gives at a right Cauchy-Green tensor C. */
struct StrainEnergy
{
  /** W per volume at rest [force/area]. */
  double value = 0;
  /** The second Piola-Kirchhoff stress S = 2 dW/dC [force/area]. */
  dealii::SymmetricTensor<2, 3> stress;
  /** 2 dS/dC [force/area]. */
  dealii::SymmetricTensor<4, 3> tangent;
};

class DecoupledLaw;

/** An elastic law for finite strain: an energy W(C) of the right Cauchy-Green
 * tensor C = F^T F, where F = 1 + grad u. */
class HyperelasticLaw : public ConstitutiveLaw
{
public:
  virtual StrainEnergy
  at(const dealii::SymmetricTensor<2, 3> &C) const = 0;

  const HyperelasticLaw *
  hyperelastic() const override
  {
    return this;
  }

  /** This, if it is a sum of energies of distortion and of volume; or null. */
  virtual const DecoupledLaw *
  decoupled() const
  {
    return nullptr;
  }

  /** Whether the energy is polyconvex (Ball 1977, Archive for Rational
   * Mechanics and Analysis 63, 337-403), so that no state loses ellipticity. */
  virtual bool
  is_polyconvex() const
  {
    return false;
  }

  /** What it is to the kernels, with the moduli at rest; nothing where they do
   * not know it. */
  virtual std::optional<NeoHookeForm>
  neo_hooke() const
  {
    return {};
  }

  /** Where the volume is not positive the energy is infinite, and the stress is
   * not set. */
  MaterialResponse
  respond(const dealii::Tensor<2, 3> &gradient,
          const bool needs_tangent = true) const;

  /** respond(). */
  MaterialResponse
  evaluate(const dealii::Tensor<2, 3> &gradient,
           const History &history,
           const bool needs_tangent) const override;
};

/** The tangent of a law in terms of F: d(F S)/dF.
 *
 * @param in_strain 2 dS/dC. */
dealii::Tensor<4, 3>
tangent_in_gradient(const dealii::Tensor<2, 3> &F,
                    const dealii::SymmetricTensor<2, 3> &S,
                    const dealii::SymmetricTensor<4, 3> &in_strain);

/** Add what a mean stress p of a change of volume does: S = p J C^-1, and its
 * tangent with dp = stiffness dJ. */
void
add_pressure(const double p,
             const double stiffness,
             const double J,
             const dealii::SymmetricTensor<2, 3> &inverse_C,
             StrainEnergy &energy);

/**
 * The neo-Hookean law of a compressible body,
 *   W = mu/2 (tr C - 3) - mu ln J + U(J),
 * with the modulus lambda in U.
 */
class NeoHooke : public HyperelasticLaw
{
public:
  NeoHooke(const Hooke &at_rest, const VolumetricForm volumetric);

  std::string
  name() const override
  {
    return "neo-Hooke";
  }

  bool
  is_polyconvex() const override
  {
    return VolumetricEnergy(form.volumetric, at_rest.lambda).is_convex();
  }

  StrainEnergy
  at(const dealii::SymmetricTensor<2, 3> &C) const override;

  std::optional<NeoHookeForm>
  neo_hooke() const override
  {
    return form;
  }

private:
  const Hooke at_rest;
  const NeoHookeForm form;
};

/**
 * Hooke's law between the Green-Lagrange strain E = (C - 1)/2 and S,
 *   W = lambda/2 (tr E)^2 + mu E : E
 * (St. Venant and Kirchhoff), for large rotations. Under a compression to 58 %
 * of the length (1/sqrt(3), without lateral strain) its force is the largest,
 * and beyond it the body collapses.
 */
class StVenantKirchhoff : public HyperelasticLaw
{
public:
  explicit StVenantKirchhoff(const Hooke &hooke);

  std::string
  name() const override
  {
    return "linear elastic (St. Venant and Kirchhoff)";
  }

  StrainEnergy
  at(const dealii::SymmetricTensor<2, 3> &C) const override;

private:
  const Hooke hooke;
};
} // namespace Setsudan
