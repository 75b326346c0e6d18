// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/decoupled_law.h>

#include <array>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

DecoupledLaw::DecoupledLaw(const Hooke &at_rest,
                           const VolumetricEnergy::Form form)
  : volumetric(form, at_rest.lambda + 2 * at_rest.mu / 3)
  , mu(at_rest.mu)
{
}



StrainEnergy
DecoupledLaw::at(const SymmetricTensor<2, 3> &C) const
{
  const double J      = std::sqrt(determinant(C));
  StrainEnergy energy = distortion(C);
  energy.value += volumetric.value(J);
  add_pressure(volumetric.derivative(J),
               volumetric.second_derivative(J),
               J,
               invert(C),
               energy);
  return energy;
}



StrainEnergy
DecoupledLaw::distortion(const SymmetricTensor<2, 3> &C,
                         const bool needs_tangent) const
{
  const double factor                 = std::pow(determinant(C), -1. / 3);
  const SymmetricTensor<2, 3> inverse = invert(C);
  const StrainEnergy free             = of_isochoric(factor * C);

  // dC'/dC = J^-2/3 P^T, with P = 1 - C^-1 (x) C / 3.
  StrainEnergy energy;
  energy.value       = free.value;
  const double along = free.stress * C;
  energy.stress      = factor * (free.stress - along / 3 * inverse);
  if (!needs_tangent)
    return energy;
  const auto tangent_of_C = free.tangent * C;
  energy.tangent          = factor * factor * free.tangent;
  // The rest is that of a pressure p of J^-2/3 times C^-1,
  const double p = -factor * along / 3;
  StrainEnergy of_pressure;
  add_pressure(p, 0, 1, inverse, of_pressure);
  energy.tangent += of_pressure.tangent;
  // and C^-1 (x) A + A (x) C^-1.
  const SymmetricTensor<2, 3> A =
    ((factor * factor * (C * tangent_of_C) / 9 - p / 3) / 2) * inverse -
    factor * factor / 3 * tangent_of_C - 2. / 3 * energy.stress;
  energy.tangent += outer_product(inverse, A) + outer_product(A, inverse);
  return energy;
}



MooneyRivlin::MooneyRivlin(const Hooke &at_rest,
                           const VolumetricEnergy::Form form,
                           const double share)
  : DecoupledLaw(at_rest, form)
  , c10(mu / 2 * (1 - share))
  , c01(mu / 2 * share)
{
}



StrainEnergy
MooneyRivlin::of_isochoric(const SymmetricTensor<2, 3> &C) const
{
  const auto one  = unit_symmetric_tensor<3>();
  const double I1 = trace(C), I2 = second_invariant(C);
  StrainEnergy energy;
  energy.value   = c10 * (I1 - 3) + c01 * (I2 - 3);
  energy.stress  = 2 * (c10 + c01 * I1) * one - 2 * c01 * C;
  energy.tangent = 4 * c01 * (outer_product(one, one) - identity_tensor<3>());
  return energy;
}



namespace
{
/** The terms whose moduli come to a shear modulus. */
Ogden::Terms
scaled(Ogden::Terms terms, const double mu)
{
  double sum = 0;
  for (const auto &[ratio, exponent] : terms)
    sum += ratio * exponent / 2;
  Assert(sum > 0, ExcMessage("The ratios give no stiffness."));
  for (auto &term : terms)
    term.first *= mu / sum;
  return terms;
}
} // namespace


Ogden::Ogden(const Hooke &at_rest,
             const VolumetricEnergy::Form form,
             const Terms &ratios)
  : DecoupledLaw(at_rest, form)
  , terms(scaled(ratios, mu))
{
}



StrainEnergy
Ogden::of_isochoric(const SymmetricTensor<2, 3> &C) const
{
  // Where two stretches are as near as that, their stresses are told apart no
  // better than to round-off.
  constexpr double alike = 1e-6;
  const auto pairs = eigenvectors(C, SymmetricTensorEigenvectorMethod::jacobi);
  StrainEnergy energy;
  std::array<double, 3> stress{}, slope{};
  std::array<SymmetricTensor<2, 3>, 3> along;
  for (unsigned int a = 0; a < 3; ++a)
    {
      const auto &[square, direction] = pairs[a];
      for (const auto &[modulus, exponent] : terms)
        {
          const double power = std::pow(square, exponent / 2);
          energy.value += modulus / exponent * (power - 1);
          stress[a] += modulus * power / square;
          slope[a] += modulus * (exponent - 2) * power / (square * square);
        }
      along[a] = symmetrize(outer_product(direction, direction));
      energy.stress += stress[a] * along[a];
      energy.tangent += slope[a] * outer_product(along[a], along[a]);
    }
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int b = 0; b < a; ++b)
      {
        const double distance = pairs[a].first - pairs[b].first;
        const double shear    = std::abs(distance) < alike * pairs[b].first
                                  ? (slope[a] + slope[b]) / 4
                                  : (stress[a] - stress[b]) / distance;
        const auto across =
          symmetrize(outer_product(pairs[a].second, pairs[b].second));
        energy.tangent += 4 * shear * outer_product(across, across);
      }
  return energy;
}
} // namespace Setsudan
