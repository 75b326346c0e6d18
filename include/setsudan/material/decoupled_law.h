// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/material/hyperelastic_law.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Setsudan
{
/**
 * A law whose energy is that of the distortion and that of the volume,
 *   W = W'(J^-2/3 C) + U(J),
 * with the bulk modulus in U; for bodies that hardly change their volume, where
 * the pressure is an unknown of its own (see LawIntegration).
 *
 * Holzapfel 2000, Nonlinear Solid Mechanics, sections 6.4 to 6.6.
 */
class DecoupledLaw : public HyperelasticLaw
{
public:
  DecoupledLaw(const Hooke &at_rest, const VolumetricEnergy::Form form);

  StrainEnergy
  at(const dealii::SymmetricTensor<2, 3> &C) const override;

  const DecoupledLaw *
  decoupled() const override
  {
    return this;
  }

  /** The part of the distortion, as a function of C. */
  StrainEnergy
  distortion(const dealii::SymmetricTensor<2, 3> &C,
             const bool needs_tangent = true) const;

  const VolumetricEnergy volumetric;

protected:
  /** W' as a function of its argument, as if that were free. */
  virtual StrainEnergy
  of_isochoric(const dealii::SymmetricTensor<2, 3> &isochoric_C) const = 0;

  const double mu;
};

/**
 * The law of Mooney and Rivlin,
 *   W' = c10 (I1 - 3) + c01 (I2 - 3),  mu = 2 (c10 + c01),
 * of the invariants of J^-2/3 C. Without the second one it is neo-Hookean.
 */
class MooneyRivlin : public DecoupledLaw
{
public:
  /** @param share c01 / (c10 + c01). */
  MooneyRivlin(const Hooke &at_rest,
               const VolumetricEnergy::Form form,
               const double share = 0);

  std::string
  name() const override
  {
    return c01 == 0 ? "isochoric neo-Hooke" : "Mooney-Rivlin";
  }

  bool
  is_polyconvex() const override
  {
    return c01 == 0 && volumetric.is_convex();
  }

  std::optional<NeoHookeForm>
  neo_hooke() const override
  {
    if (c01 != 0)
      return {};
    return NeoHookeForm{volumetric.form, true};
  }

  const double c10;
  const double c01;

private:
  StrainEnergy
  of_isochoric(const dealii::SymmetricTensor<2, 3> &C) const override;
};

/**
 * Ogden's law,
 *   W' = sum of mu_p / alpha_p (a^alpha_p + b^alpha_p + c^alpha_p - 3),
 *   mu = sum of mu_p alpha_p / 2,
 * of the principal stretches a, b, c of J^-2/3 C.
 *
 * Ogden 1972, Proceedings of the Royal Society A 326, 565-584.
 */
class Ogden : public DecoupledLaw
{
public:
  /** mu_p and alpha_p. */
  using Terms = std::vector<std::pair<double, double>>;

  /** @param ratios of mu_p to each other, which are scaled to mu. */
  Ogden(const Hooke &at_rest,
        const VolumetricEnergy::Form form,
        const Terms &ratios);

  std::string
  name() const override
  {
    return "Ogden";
  }

  const Terms terms;

private:
  StrainEnergy
  of_isochoric(const dealii::SymmetricTensor<2, 3> &C) const override;
};
} // namespace Setsudan
