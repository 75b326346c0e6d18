// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/hyperelastic_law.h>

#include <cmath>
#include <limits>

namespace Setsudan
{
using namespace dealii;

VolumetricEnergy::VolumetricEnergy(const Form form, const double modulus)
  : form(form)
  , modulus(modulus)
{
}



double
VolumetricEnergy::value(const double J) const
{
  const double logarithm = std::log(J);
  switch (form)
    {
      case Form::ciarlet:
        return modulus * (J * J - 1 - 2 * logarithm) / 4;
      case Form::quadratic:
        return modulus * (J - 1) * (J - 1) / 2;
      case Form::logarithmic:
        return modulus * logarithm * logarithm / 2;
    }
  return 0;
}



double
VolumetricEnergy::derivative(const double J) const
{
  switch (form)
    {
      case Form::ciarlet:
        return modulus * (J - 1 / J) / 2;
      case Form::quadratic:
        return modulus * (J - 1);
      case Form::logarithmic:
        return modulus * std::log(J) / J;
    }
  return 0;
}



double
VolumetricEnergy::second_derivative(const double J) const
{
  switch (form)
    {
      case Form::ciarlet:
        return modulus * (1 + 1 / (J * J)) / 2;
      case Form::quadratic:
        return modulus;
      case Form::logarithmic:
        return modulus * (1 - std::log(J)) / (J * J);
    }
  return 0;
}



MaterialResponse
HyperelasticLaw::evaluate(const Tensor<2, 3> &gradient,
                          const History &,
                          const bool needs_tangent) const
{
  return respond(gradient, needs_tangent);
}



MaterialResponse
HyperelasticLaw::respond(const Tensor<2, 3> &gradient,
                         const bool needs_tangent) const
{
  const Tensor<2, 3> F = gradient + unit_symmetric_tensor<3>();
  MaterialResponse response;
  if (!(determinant(F) > 0))
    {
      response.energy.potential = std::numeric_limits<double>::infinity();
      return response;
    }
  const StrainEnergy energy = at(symmetrize(transpose(F) * F));
  response.energy           = Energy::elastic(energy.value);
  response.stress           = F * energy.stress;
  if (needs_tangent)
    response.tangent = tangent_in_gradient(F, energy.stress, energy.tangent);
  return response;
}



Tensor<4, 3>
tangent_in_gradient(const Tensor<2, 3> &F,
                    const SymmetricTensor<2, 3> &S,
                    const SymmetricTensor<4, 3> &in_strain)
{
  Tensor<4, 3> result;
  for (unsigned int J = 0; J < 3; ++J)
    for (unsigned int L = 0; L < 3; ++L)
      {
        Tensor<2, 3> moduli;
        for (unsigned int I = 0; I < 3; ++I)
          for (unsigned int K = 0; K < 3; ++K)
            moduli[I][K] = in_strain[I][J][K][L];
        const Tensor<2, 3> pushed = F * moduli * transpose(F);
        for (unsigned int i = 0; i < 3; ++i)
          {
            for (unsigned int k = 0; k < 3; ++k)
              result[i][J][k][L] = pushed[i][k];
            result[i][J][i][L] += S[J][L];
          }
      }
  return result;
}



namespace
{
/** A (x) A, of which the components are A_ik A_jl, in its symmetric form. */
SymmetricTensor<4, 3>
symmetric_square(const SymmetricTensor<2, 3> &A)
{
  SymmetricTensor<4, 3> result;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = i; j < 3; ++j)
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int l = k; l < 3; ++l)
          result[i][j][k][l] = (A[i][k] * A[j][l] + A[i][l] * A[j][k]) / 2;
  return result;
}
} // namespace


void
add_pressure(const double p,
             const double stiffness,
             const double J,
             const SymmetricTensor<2, 3> &inverse_C,
             StrainEnergy &energy)
{
  energy.stress += p * J * inverse_C;
  energy.tangent +=
    (p * J + stiffness * J * J) * outer_product(inverse_C, inverse_C) -
    2 * p * J * symmetric_square(inverse_C);
}



NeoHooke::NeoHooke(const Hooke &at_rest, const VolumetricForm volumetric)
  : at_rest(at_rest)
  , form({volumetric, false})
{
}



StrainEnergy
NeoHooke::at(const SymmetricTensor<2, 3> &C) const
{
  const auto one     = unit_symmetric_tensor<3>();
  const auto inverse = invert(C);
  const double J     = std::sqrt(determinant(C));
  const auto terms   = neo_hooke_terms<double>(
    form, at_rest.mu, at_rest.lambda, J, std::log(J), 1, trace(C));
  StrainEnergy energy;
  energy.value   = terms.energy;
  energy.stress  = terms.one * one + terms.inverse * inverse;
  energy.tangent = terms.square * outer_product(inverse, inverse) -
                   2 * terms.inverse * symmetric_square(inverse);
  return energy;
}



StVenantKirchhoff::StVenantKirchhoff(const Hooke &hooke)
  : hooke(hooke)
{
}



StrainEnergy
StVenantKirchhoff::at(const SymmetricTensor<2, 3> &C) const
{
  const SymmetricTensor<2, 3> strain = (C - unit_symmetric_tensor<3>()) / 2;
  StrainEnergy energy;
  energy.stress  = hooke.stress(strain);
  energy.value   = energy.stress * strain / 2;
  energy.tangent = hooke.lambda * outer_product(unit_symmetric_tensor<3>(),
                                                unit_symmetric_tensor<3>()) +
                   2 * hooke.mu * identity_tensor<3>();
  return energy;
}
} // namespace Setsudan
