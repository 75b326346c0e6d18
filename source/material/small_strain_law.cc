// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/physics/elasticity/standard_tensors.h>

#include <setsudan/material/small_strain_law.h>

namespace Setsudan
{
using namespace dealii;

MaterialResponse
SmallStrainLaw::evaluate(const Tensor<2, 3> &gradient,
                         const History &history,
                         const bool needs_tangent) const
{
  using Unit          = Physics::Elasticity::StandardTensors<3>;
  const auto strain   = symmetrize(gradient);
  const auto response = respond(strain, trace(strain), history);
  return {Tensor<2, 3>(response.stress),
          needs_tangent
            ? Tensor<4, 3>(response.tangent + response.lambda * Unit::IxI)
            : Tensor<4, 3>(),
          response.energy};
}



LinearElasticity::LinearElasticity(const Hooke &hooke)
  : hooke(hooke)
{
}



SmallStrainResponse
LinearElasticity::respond(const SymmetricTensor<2, 3> &strain,
                          const double dilatation,
                          const History &) const
{
  return {hooke.stress(strain, dilatation),
          2 * hooke.mu * Physics::Elasticity::StandardTensors<3>::S,
          hooke.lambda * dilatation,
          hooke.lambda,
          Energy::elastic(hooke.lambda / 2 * dilatation * dilatation +
                          hooke.mu * (strain * strain))};
}
} // namespace Setsudan
