// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/physics/elasticity/standard_tensors.h>

#include <setsudan/material/j2_plasticity.h>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Which component of a strain each internal variable is. */
constexpr unsigned int row[]    = {0, 1, 2, 0, 1, 2};
constexpr unsigned int column[] = {0, 1, 2, 1, 2, 0};
constexpr unsigned int n_strain = 6;
// Of the yield stress, an excess that is round-off: a state that has been
// accepted stays as it is.
constexpr double round_off = 1e-12;
} // namespace


J2Plasticity::J2Plasticity(const Hooke &hooke,
                           const double yield_stress,
                           const Hardening &hardening)
  : hooke(hooke)
  , yield_stress(yield_stress)
  , hardening(hardening)
{
}



unsigned int
J2Plasticity::n_internal() const
{
  return n_strain + 1;
}



void
J2Plasticity::initialize(const ArrayView<double> &internal) const
{
  std::fill(internal.begin(), internal.end(), 0.);
}



SmallStrainResponse
J2Plasticity::respond(const SymmetricTensor<2, 3> &strain,
                      const double dilatation,
                      const History &history) const
{
  using Unit      = Physics::Elasticity::StandardTensors<3>;
  const double mu = hooke.mu;
  SymmetricTensor<2, 3> plastic;
  for (unsigned int i = 0; i < n_strain; ++i)
    plastic[row[i]][column[i]] = history.before[i];
  double accumulated = history.before[n_strain];

  SmallStrainResponse response;
  auto &stress      = response.stress;
  auto &tangent     = response.tangent;
  stress            = hooke.stress(strain, dilatation) - 2 * mu * plastic;
  const auto shift  = deviator(stress) - 2. / 3 * hardening.kinematic * plastic;
  const double size = shift.norm();
  const double excess =
    size - std::sqrt(2. / 3) *
             (yield_stress + hardening.isotropic * std::max(accumulated, 0.));
  tangent              = 2 * mu * Unit::S;
  response.mean_stress = hooke.lambda * dilatation;
  response.lambda      = hooke.lambda;
  if (excess > round_off * yield_stress)
    {
      const double resistance =
        2 * mu + 2. / 3 * (hardening.isotropic + hardening.kinematic);
      const double flow    = excess / resistance;
      const auto direction = shift / size;
      plastic += flow * direction;
      accumulated += std::sqrt(2. / 3) * flow;
      stress -= 2 * mu * flow * direction;
      const double turned = 2 * mu * flow / size;
      tangent -= 2 * mu *
                 (turned * Unit::dev_P + (2 * mu / resistance - turned) *
                                           outer_product(direction, direction));
    }
  for (unsigned int i = 0; i < n_strain; ++i)
    history.after[i] = plastic[row[i]][column[i]];
  history.after[n_strain] = accumulated;

  const auto elastic = strain - plastic;
  response.energy = Energy::elastic(hooke.lambda / 2 * dilatation * dilatation +
                                    mu * (elastic * elastic));
  response.energy.plastic =
    yield_stress * accumulated +
    hardening.isotropic * accumulated * accumulated / 2 +
    hardening.kinematic / 3 * (plastic * plastic);
  response.energy.potential += response.energy.plastic;
  return response;
}
} // namespace Setsudan
