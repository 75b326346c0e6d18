// SPDX-License-Identifier: LGPL-2.1-or-later
// Laws of small strain for logarithmic strain: stress and tangent as
// derivatives of the energy, with equal and with nearly equal principal
// stretches too; closed forms of bars; a rotation changes nothing.

#include <setsudan/material/j2_plasticity.h>
#include <setsudan/material/logarithmic_strain.h>
#include <setsudan/material/viscoelasticity.h>

#include <cmath>
#include <memory>
#include <vector>

#include "law_at_point.h"

using namespace Setsudan;
using namespace dealii;

constexpr double E = 5, nu = 0.3, yield_stress = 0.5;


template <typename Law, typename... Arguments>
std::shared_ptr<const SmallStrainLaw>
make(const Arguments &...arguments)
{
  return std::make_shared<const Law>(arguments...);
}


/** Where principal stretches differ by so much. */
void
test_near(const double distance)
{
  const LogarithmicStrain law(make<LinearElasticity>(Hooke(E, nu)));
  Tensor<2, 3> gradient, turned;
  gradient[0][0] = 0.3;
  gradient[1][1] = 0.3 + distance;
  gradient[2][2] = 0.3 - 0.7 * distance;
  // Off the axes.
  turned[0][1] = -0.6;
  turned[1][0] = 0.6;
  turned[0][2] = turned[2][0] = 0.1;
  const auto one              = unit_symmetric_tensor<3>();
  const Tensor<2, 3> frame    = project_onto_orthogonal_tensors(one + turned);
  const Tensor<2, 3> about    = transpose(frame) * gradient * frame;
  test_derivatives_at(about, law, {});
}


/** The nominal stress of a bar that is stretched in a step. */
double
pull(const LogarithmicStrain &law,
     const double stretch,
     const double duration,
     std::vector<double> &internal,
     double &across)
{
  Tensor<2, 3> gradient;
  gradient[0][0] = stretch - 1;
  gradient[1][1] = gradient[2][2]  = across;
  const std::vector<double> before = internal;
  MaterialResponse response;
  for (unsigned int i = 0; i < 30; ++i)
    {
      response       = evaluate(law, gradient, before, internal, duration);
      const auto &of = response.tangent;
      gradient[1][1] = gradient[2][2] =
        gradient[1][1] -
        response.stress[1][1] / (of[1][1][1][1] + of[1][1][2][2]);
    }
  across = gradient[1][1];
  return response.stress[0][0];
}


void
test_bars()
{
  double elastic = 0, plastic = 0, flowing = 0;
  for (const double stretch : {0.5, 0.8, 1.2, 2., 3.})
    {
      const double strain = std::log(stretch);
      // Kirchhoff's stress is E times the strain; it is that over the cross
      // section at rest, times the stretch.
      std::vector<double> none;
      double across = 0;
      const LogarithmicStrain hencky(make<LinearElasticity>(Hooke(E, nu)));
      elastic = std::max(
        elastic,
        std::abs(
          pull(hencky, stretch, 0, none, across) * stretch / (E * strain) - 1));
      elastic =
        std::max(elastic, std::abs(1 + across - std::pow(stretch, -nu)));
      constexpr double H = 0.4;
      const LogarithmicStrain clay(
        make<J2Plasticity>(Hooke(E, nu), yield_stress, Hardening{H, 0}));
      auto internal       = at_rest(clay);
      across              = 0;
      const double stress = pull(clay, stretch, 0, internal, across) * stretch;
      const double sign   = strain > 0 ? 1 : -1;
      const double limit  = sign * yield_stress;
      const double expected = limit + E * H / (E + H) * (strain - limit / E);
      plastic = std::max(plastic, std::abs(stress / expected - 1));
      // Plastic flow keeps the volume.
      const double volume = stretch * std::pow(1 + across, 2);
      flowing             = std::max(
        flowing, std::abs(std::log(volume) - (1 - 2 * nu) * stress / E));
    }
  check_below("bar of Hencky's energy", elastic, 1e-12);
  check_below("bar that flows", plastic, 1e-12);
  check_below("  its volume", flowing, 1e-12);

  // Of a rate of the logarithmic strain, that of the standard linear solid.
  const Hooke at_once(3, nu);
  const Relaxation relaxation{{{2. / 3, 0.5}}, {{2. / 3, 0.5}}};
  const LogarithmicStrain gel(make<Viscoelasticity>(
    make<LinearElasticity>(relaxation.long_after(at_once)),
    at_once,
    relaxation));
  auto internal = at_rest(gel);
  double across = 0, stress = 0;
  for (unsigned int i = 1; i <= 4; ++i)
    stress = pull(gel, std::exp(0.25 * i), 0.25, internal, across);
  check_below(
    "bar of a viscous body", std::abs(stress * std::exp(1.) - 1.864665), 1e-6);
}


void
test_rotation()
{
  const LogarithmicStrain law(
    make<J2Plasticity>(Hooke(E, nu), yield_stress, Hardening{0.7, 0.4}));
  Tensor<2, 3> gradient, spin;
  gradient[0][1]              = 0.9;
  gradient[2][2]              = -0.2;
  spin[0][1]                  = -1.3;
  spin[1][0]                  = 1.3;
  spin[1][2]                  = 0.8;
  spin[2][1]                  = -0.8;
  const auto one              = unit_symmetric_tensor<3>();
  const Tensor<2, 3> rotation = project_onto_orthogonal_tensors(one + spin);
  std::vector<double> first, second;
  const auto before  = at_rest(law);
  const auto upright = evaluate(law, gradient, before, first);
  const auto rotated =
    evaluate(law, rotation * (one + gradient) - one, before, second);
  check_below("a rotation: energy",
              std::abs(rotated.energy.potential / upright.energy.potential - 1),
              1e-13);
  check_below(
    "  stress", (rotated.stress - rotation * upright.stress).norm(), 1e-13);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    const Hooke hooke(E, nu);
    const Relaxation relaxation{{{0.3, 0.1}, {0.2, 4}}, {{0.1, 1}}};
    const Hooke lasting = relaxation.long_after(hooke);
    for (const auto &law :
         {make<LinearElasticity>(hooke),
          make<J2Plasticity>(hooke, yield_stress, Hardening{0.7, 0.4}),
          make<Viscoelasticity>(
            make<J2Plasticity>(lasting, yield_stress, Hardening{0.7, 0.4}),
            hooke,
            relaxation)})
      test_derivatives(LogarithmicStrain(law), 0.3, 0.4);
    for (const double distance : {0., 1e-9, 1e-6, 1e-4, 1e-3, 1e-2, 0.1})
      test_near(distance);
    test_bars();
    test_rotation();
  });
}
