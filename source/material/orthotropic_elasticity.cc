// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/orthotropic_elasticity.h>

#include <cmath>

namespace Setsudan
{
using namespace dealii;

namespace
{
// A determinant that is smaller may be that of an incompressible material.
constexpr double smallest_determinant = 1e-12;

/** The compliance between normal strains and stresses, each in units of the
 * root of its Young's modulus, so that the diagonal is 1. */
SymmetricTensor<2, 3>
scaled_compliance(const OrthotropicConstants &constants)
{
  SymmetricTensor<2, 3> scaled = unit_symmetric_tensor<3>();
  for (unsigned int i = 0; i < 3; ++i)
    {
      const unsigned int j = (i + 1) % 3;
      scaled[i][j] =
        -constants.poissons_ratios[i] *
        std::sqrt(constants.youngs_moduli[j] / constants.youngs_moduli[i]);
    }
  return scaled;
}



/** The stiffness between normal strains and stresses along the axes. */
SymmetricTensor<2, 3>
normal_stiffness(const OrthotropicConstants &constants)
{
  SymmetricTensor<2, 3> stiffness = invert(scaled_compliance(constants));
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j <= i; ++j)
      stiffness[i][j] *=
        std::sqrt(constants.youngs_moduli[i] * constants.youngs_moduli[j]);
  return stiffness;
}
} // namespace


bool
OrthotropicConstants::are_definite() const
{
  const auto scaled = scaled_compliance(*this);
  return 1 - scaled[0][1] * scaled[0][1] > smallest_determinant &&
         determinant(scaled) > smallest_determinant;
}



SymmetricTensor<4, 3>
OrthotropicConstants::stiffness() const
{
  const auto normal = normal_stiffness(*this);
  SymmetricTensor<4, 3> result;
  for (unsigned int i = 0; i < 3; ++i)
    {
      const auto along = symmetrize(outer_product(axes[i], axes[i]));
      for (unsigned int j = 0; j < 3; ++j)
        result +=
          normal[i][j] *
          outer_product(along, symmetrize(outer_product(axes[j], axes[j])));
      const auto shear = symmetrize(outer_product(axes[i], axes[(i + 1) % 3]));
      result += 4 * shear_moduli[i] * outer_product(shear, shear);
    }
  return result;
}



Hooke
OrthotropicConstants::isotropic_mean() const
{
  const auto normal = normal_stiffness(*this);
  double diagonal = 0, beside = 0, shear = 0;
  for (unsigned int i = 0; i < 3; ++i)
    {
      diagonal += normal[i][i] / 3;
      beside += normal[i][(i + 1) % 3] / 3;
      shear += shear_moduli[i] / 3;
    }
  const double bulk = (diagonal + 2 * beside) / 3;
  const double mu   = (diagonal - beside + 3 * shear) / 5;
  return {9 * bulk * mu / (3 * bulk + mu),
          (3 * bulk - 2 * mu) / (2 * (3 * bulk + mu))};
}



OrthotropicElasticity::OrthotropicElasticity(
  const OrthotropicConstants &constants)
  : constants(constants)
  , stiffness(constants.stiffness())
{
}



SmallStrainResponse
OrthotropicElasticity::respond(const SymmetricTensor<2, 3> &strain,
                               const double,
                               const History &) const
{
  SmallStrainResponse response;
  response.stress  = stiffness * strain;
  response.tangent = stiffness;
  response.energy  = Energy::elastic(response.stress * strain / 2);
  return response;
}



OrthotropicStVenantKirchhoff::OrthotropicStVenantKirchhoff(
  const OrthotropicConstants &constants)
  : stiffness(constants.stiffness())
{
}



StrainEnergy
OrthotropicStVenantKirchhoff::at(const SymmetricTensor<2, 3> &C) const
{
  const SymmetricTensor<2, 3> strain = (C - unit_symmetric_tensor<3>()) / 2;
  StrainEnergy energy;
  energy.stress  = stiffness * strain;
  energy.value   = energy.stress * strain / 2;
  energy.tangent = stiffness;
  return energy;
}
} // namespace Setsudan
