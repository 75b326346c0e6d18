// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/finite_strain_law.h>

#include <limits>

namespace Setsudan
{
using namespace dealii;

MaterialResponse
FiniteStrainLaw::evaluate(const Tensor<2, 3> &gradient,
                          const History &history,
                          const bool needs_tangent) const
{
  const Tensor<2, 3> F = gradient + unit_symmetric_tensor<3>();
  const double J       = determinant(F);
  MaterialResponse response;
  if (!(J > 0))
    {
      response.energy.potential = std::numeric_limits<double>::infinity();
      return response;
    }
  const SymmetricTensor<2, 3> C = symmetrize(transpose(F) * F);
  auto of_law                   = respond(C, J, history, needs_tangent);
  StrainEnergy &all             = of_law.distortion;
  add_pressure(of_law.mean_stress, of_law.stiffness, J, invert(C), all);
  response.stress = F * all.stress;
  if (needs_tangent)
    response.tangent = tangent_in_gradient(F, all.stress, all.tangent);
  response.energy = of_law.energy;
  return response;
}
} // namespace Setsudan
