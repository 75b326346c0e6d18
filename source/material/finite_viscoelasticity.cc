// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/finite_viscoelasticity.h>
#include <setsudan/material/principal_axes.h>
#include <setsudan/parameters/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Energy, stresses and moduli of a distortion in its principal axes, by its
 * logarithmic strains. */
struct PrincipalResponse
{
  double energy;
  Tensor<1, 3> stress;
  SymmetricTensor<2, 3> moduli;
};

PrincipalResponse
respond_in_axes(const DecoupledLaw &law, const Tensor<1, 3> &strain)
{
  SymmetricTensor<2, 3> C;
  for (unsigned int a = 0; a < 3; ++a)
    C[a][a] = std::exp(2 * strain[a]);
  const StrainEnergy energy = law.distortion(C);
  PrincipalResponse response;
  response.energy = energy.value;
  for (unsigned int a = 0; a < 3; ++a)
    {
      response.stress[a]    = C[a][a] * energy.stress[a][a];
      response.moduli[a][a] = 2 * response.stress[a];
      for (unsigned int b = 0; b <= a; ++b)
        response.moduli[a][b] += C[a][a] * energy.tangent[a][a][b][b] * C[b][b];
    }
  return response;
}



/** The elastic part of a strain of spring and dashpot after a step.
 *
 * @param compliance of the dashpot in this step.
 * @param found the response to it; is set.
 * @throw SolverError where there is none. */
Tensor<1, 3>
elastic_strain(const DecoupledLaw &law,
               const Tensor<1, 3> &strain,
               const double compliance,
               PrincipalResponse &found)
{
  constexpr unsigned int most_steps = 50, most_halvings = 30;
  constexpr double round_off = 1e-14;
  // Of which the elastic strain is the minimum, times the compliance.
  const auto objective = [&](const Tensor<1, 3> &elastic,
                             const PrincipalResponse &response) {
    return compliance * response.energy + (elastic - strain).norm_square() / 2;
  };
  Tensor<1, 3> elastic = strain;
  found                = respond_in_axes(law, elastic);
  if (compliance == 0)
    return elastic;
  for (unsigned int step = 0; step < most_steps; ++step)
    {
      const Tensor<1, 3> residual =
        elastic - strain + compliance * found.stress;
      if (residual.norm() <= round_off * (1 + strain.norm()))
        return elastic;
      const Tensor<1, 3> change =
        -invert(unit_symmetric_tensor<3>() + compliance * found.moduli) *
        residual;
      const double before     = objective(elastic, found);
      const Tensor<1, 3> from = elastic;
      double length           = 1;
      for (unsigned int i = 0; i < most_halvings; ++i, length /= 2)
        {
          elastic = from + length * change;
          found   = respond_in_axes(law, elastic);
          if (objective(elastic, found) <= before + round_off)
            break;
        }
      // As far as round-off allows.
      if (length * change.norm() <= round_off * (1 + strain.norm()))
        return elastic;
    }
  throw SolverError("The flow of a dashpot of Material/Viscous could not be "
                    "found: take shorter steps of time, or set Material/Law = "
                    "auto.");
}



/** The stress of a spring, conjugate to the logarithmic strain of spring and
 * dashpot. */
SymmetricTensor<2, 3>
stress_in_space(const PrincipalAxes &axes, const PrincipalResponse &spring)
{
  SymmetricTensor<2, 3> stress;
  for (unsigned int a = 0; a < 3; ++a)
    stress += spring.stress[a] *
              symmetrize(outer_product(axes.direction(a), axes.direction(a)));
  return stress;
}



/** Its derivative by that strain. */
SymmetricTensor<4, 3>
tangent_in_space(const PrincipalAxes &axes,
                 const PrincipalResponse &spring,
                 const double compliance)
{
  const Tensor<2, 3> moduli =
    spring.moduli * invert(Tensor<2, 3>(unit_symmetric_tensor<3>() +
                                        compliance * spring.moduli));
  constexpr double alike = 1e-7;
  const auto between     = [&](const unsigned int a, const unsigned int b) {
    return symmetrize(outer_product(axes.direction(a), axes.direction(b)));
  };
  SymmetricTensor<4, 3> tangent;
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int b = 0; b < 3; ++b)
      {
        tangent += moduli[a][b] * outer_product(between(a, a), between(b, b));
        if (b <= a)
          continue;
        const double distance = axes.logarithm(a) - axes.logarithm(b);
        const double shear =
          std::abs(distance) < alike
            ? (moduli[a][a] - moduli[a][b] - moduli[b][a] + moduli[b][b]) / 2
            : (spring.stress[a] - spring.stress[b]) / distance;
        tangent += 2 * shear * outer_product(between(a, b), between(a, b));
      }
  return tangent;
}



/** A stress by Fv^-T C Fv^-1 as that by C. */
SymmetricTensor<2, 3>
pulled_back(const Tensor<2, 3> &inverse, const SymmetricTensor<2, 3> &stress)
{
  return symmetrize(inverse * stress * transpose(inverse));
}



/** The same of a tangent. */
SymmetricTensor<4, 3>
pulled_back(const Tensor<2, 3> &inverse, const SymmetricTensor<4, 3> &tangent)
{
  SymmetricTensor<4, 3> by_C;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j <= i; ++j)
      {
        Tensor<1, 3> first, second;
        first[i]        = 1;
        second[j]       = 1;
        const auto unit = symmetrize(outer_product(first, second));
        const SymmetricTensor<2, 3> change = pulled_back(
          inverse,
          SymmetricTensor<2, 3>(
            tangent * symmetrize(transpose(inverse) * unit * inverse)));
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int l = 0; l <= k; ++l)
            by_C[k][l][i][j] = change[k][l];
      }
  return by_C;
}
} // namespace


FiniteViscoelasticity::FiniteViscoelasticity(
  const std::shared_ptr<const DecoupledLaw> &law,
  const Hooke &at_once,
  const Relaxation::Terms &terms)
  : law(law)
  , mu(at_once.mu)
  , terms(terms)
  , lasting_part(Relaxation::lasting_part(terms))
{
}



std::string
FiniteViscoelasticity::name() const
{
  return "viscous " + law->name();
}



unsigned int
FiniteViscoelasticity::n_internal() const
{
  return 1 + 9 * terms.size();
}



void
FiniteViscoelasticity::initialize(const ArrayView<double> &internal) const
{
  std::fill(internal.begin(), internal.end(), 0.);
}



FiniteStrainLaw::Response
FiniteViscoelasticity::respond(const SymmetricTensor<2, 3> &C,
                               const double volume,
                               const History &history,
                               const bool needs_tangent) const
{
  Response response;
  response.mean_stress = law->volumetric.derivative(volume);
  response.stiffness   = law->volumetric.second_derivative(volume);
  response.distortion  = law->distortion(C, needs_tangent);
  response.distortion.stress *= lasting_part;
  response.distortion.tangent *= lasting_part;
  const double lasting =
    law->volumetric.value(volume) + lasting_part * response.distortion.value;
  response.energy         = Energy::elastic(lasting);
  response.energy.viscous = history.before[0];
  response.energy.potential += history.before[0];
  for (unsigned int t = 0; t < terms.size(); ++t)
    {
      const auto &[part, time]   = terms[t];
      const double compliance    = history.time_step / (2 * mu * time);
      const double *const before = history.before.data() + 1 + 9 * t;
      Tensor<2, 3> inverse;
      for (unsigned int i = 0; i < 9; ++i)
        inverse[i / 3][i % 3] = before[i] + (i % 4 == 0 ? 1 : 0);
      const PrincipalAxes axes(symmetrize(transpose(inverse) * C * inverse));
      Tensor<1, 3> strain;
      for (unsigned int a = 0; a < 3; ++a)
        strain[a] = axes.logarithm(a);
      PrincipalResponse spring;
      const auto elastic = elastic_strain(*law, strain, compliance, spring);
      const auto stress  = stress_in_space(axes, spring);
      response.distortion.stress +=
        part * pulled_back(inverse, axes.stress(stress));
      if (needs_tangent)
        response.distortion.tangent +=
          part *
          pulled_back(
            inverse,
            axes.tangent(stress, tangent_in_space(axes, spring, compliance)));

      Tensor<2, 3> flow;
      for (unsigned int a = 0; a < 3; ++a)
        flow += std::exp(elastic[a] - strain[a]) *
                outer_product(axes.direction(a), axes.direction(a));
      const Tensor<2, 3> after = inverse * flow;
      for (unsigned int i = 0; i < 9; ++i)
        history.after[1 + 9 * t + i] =
          after[i / 3][i % 3] - (i % 4 == 0 ? 1 : 0);
      const double heat =
        compliance > 0 ? part * (strain - elastic).norm_square() / compliance
                       : 0;
      response.energy.stored += part * spring.energy;
      response.energy.viscous += heat;
      response.energy.potential += part * spring.energy + heat / 2;
    }
  history.after[0] = response.energy.viscous;
  return response;
}
} // namespace Setsudan
