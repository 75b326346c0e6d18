// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/physics/elasticity/standard_tensors.h>

#include <setsudan/material/constitutive_law.h>

namespace Setsudan
{
using namespace dealii;

LinearElasticity::LinearElasticity(const Hooke &hooke)
  : hooke(hooke)
{
}



const Hooke *
LinearElasticity::linear() const
{
  return &hooke;
}



MaterialResponse
LinearElasticity::evaluate(const Tensor<2, 3> &gradient,
                           const ArrayView<const double> &,
                           const ArrayView<double> &) const
{
  using Unit        = Physics::Elasticity::StandardTensors<3>;
  const auto strain = symmetrize(gradient);
  const auto stress = hooke.stress(strain);
  const SymmetricTensor<4, 3> tangent =
    hooke.lambda * Unit::IxI + 2 * hooke.mu * Unit::S;
  return {Tensor<2, 3>(stress), Tensor<4, 3>(tangent), 0.5 * (stress * strain)};
}
} // namespace Setsudan
