// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/symmetric_tensor.h>

#include <setsudan/material/hyperelastic_law.h>
#include <setsudan/material/material_axes.h>
#include <setsudan/material/small_strain_law.h>

#include <array>
#include <string>

namespace Setsudan
{
/**
 * The constants of an orthotropic material: the compliance in its axes is
 *   e_11 = s_11/E1 - nu12/E1 s_22 - nu31/E3 s_33,  e_12 = s_12/(2 G12),
 * and so on in turn. nu_ij is the strain along j over that along i, with the
 * opposite sign, under a stress along i; nu_ij/E_i = nu_ji/E_j.
 *
 * Lekhnitskii 1963, Theory of Elasticity of an Anisotropic Elastic Body.
 */
struct OrthotropicConstants
{
  /** E1, E2, E3 [force/area]. */
  std::array<double, 3> youngs_moduli;
  /** nu12, nu23, nu31. */
  std::array<double, 3> poissons_ratios;
  /** G12, G23, G31 [force/area]. */
  std::array<double, 3> shear_moduli;
  MaterialAxes axes;

  /** Whether every strain stores energy; moduli must be positive. */
  bool
  are_definite() const;

  /** In the axes of the body [force/area]. Constants must be definite. */
  dealii::SymmetricTensor<4, 3>
  stiffness() const;

  /** The isotropic law that is nearest to the stiffness, its mean over all
   * orientations (Voigt); the law itself where that is isotropic. */
  Hooke
  isotropic_mean() const;
};

/** Orthotropic elasticity under small strain, in the displacement formulation.
 */
class OrthotropicElasticity : public SmallStrainLaw
{
public:
  explicit OrthotropicElasticity(const OrthotropicConstants &constants);

  std::string
  name() const override
  {
    return "orthotropic linear elastic";
  }

  bool
  is_linear() const override
  {
    return true;
  }

  const dealii::SymmetricTensor<4, 3> *
  anisotropic_stiffness() const override
  {
    return &stiffness;
  }

  /** @param dilatation must be the trace of the strain. */
  SmallStrainResponse
  respond(const dealii::SymmetricTensor<2, 3> &strain,
          const double dilatation,
          const History &history) const override;

  const OrthotropicConstants constants;

private:
  const dealii::SymmetricTensor<4, 3> stiffness;
};

/** The same between the Green-Lagrange strain and the second Piola-Kirchhoff
 * stress, for large rotations (see StVenantKirchhoff). */
class OrthotropicStVenantKirchhoff : public HyperelasticLaw
{
public:
  explicit OrthotropicStVenantKirchhoff(const OrthotropicConstants &constants);

  std::string
  name() const override
  {
    return "orthotropic linear elastic (St. Venant and Kirchhoff)";
  }

  StrainEnergy
  at(const dealii::SymmetricTensor<2, 3> &C) const override;

private:
  const dealii::SymmetricTensor<4, 3> stiffness;
};
} // namespace Setsudan
