// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/logarithmic_strain.h>
#include <setsudan/material/principal_axes.h>

#include <cmath>

namespace Setsudan
{
using namespace dealii;

LogarithmicStrain::LogarithmicStrain(
  const std::shared_ptr<const SmallStrainLaw> &law)
  : law(law)
{
}



std::string
LogarithmicStrain::name() const
{
  return (law->is_linear() ? "Hooke's law" : law->name()) +
         " of logarithmic strain";
}



FiniteStrainLaw::Response
LogarithmicStrain::respond(const SymmetricTensor<2, 3> &C,
                           const double volume,
                           const History &history,
                           const bool needs_tangent) const
{
  const PrincipalAxes axes(C);
  const auto of_law = law->respond(axes.logarithm(), std::log(volume), history);
  Response response;
  response.energy      = of_law.energy;
  response.mean_stress = of_law.mean_stress / volume;
  response.stiffness = (of_law.lambda - of_law.mean_stress) / (volume * volume);
  const auto without_volume =
    of_law.stress - of_law.mean_stress * unit_symmetric_tensor<3>();
  response.distortion.stress = axes.stress(without_volume);
  if (needs_tangent)
    response.distortion.tangent = axes.tangent(without_volume, of_law.tangent);
  return response;
}
} // namespace Setsudan
