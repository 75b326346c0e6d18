// SPDX-License-Identifier: LGPL-2.1-or-later
// Viscosity of hyperelastic laws: a bar of a standard solid by the numbers of
// an independent solution of the model of Reese and Govindjee; small strains as
// the linear theory has them; a sudden strain; stress and tangent as
// derivatives of the energy.

#include <setsudan/material/finite_viscoelasticity.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "law_at_point.h"

using namespace Setsudan;
using namespace dealii;

using Form = VolumetricEnergy::Form;


/** The stress of an incompressible bar that is stretched from 1 to 1.5 within a
 * unit of time and held, at times from then on, with so many steps in each
 * unit. The moduli are 1, which lasts, and 1.5, whose time is 1. */
std::array<double, 6>
stretch(const unsigned int n_steps)
{
  constexpr double mu                   = 2.5;
  constexpr std::array<double, 6> times = {{0.25, 0.5, 1, 1.5, 2, 4}};
  const Hooke at_once(3 * mu, 0.4999999);
  const FiniteViscoelasticity law(
    std::make_shared<const MooneyRivlin>(at_once, Form::quadratic),
    at_once,
    {{0.6, 1}});
  auto internal = at_rest(law);
  std::array<double, 6> stresses{};
  unsigned int next = 0;
  for (unsigned int step = 1; next < times.size(); ++step)
    {
      const double time = 1. * step / n_steps;
      const double a    = 1 + 0.5 * std::min(time, 1.);
      SymmetricTensor<2, 3> C;
      C[0][0] = a * a;
      C[1][1] = C[2][2]   = 1 / a;
      auto after          = internal;
      const auto response = law.respond(C,
                                        1,
                                        {{internal.data(), internal.size()},
                                         {after.data(), after.size()},
                                         1. / n_steps},
                                        false);
      internal            = after;
      // Nothing pulls across.
      const auto &S = response.distortion.stress;
      if (std::abs(time - times[next]) < 1e-9)
        stresses[next++] = a * a * S[0][0] - S[1][1] / a;
    }
  return stresses;
}


void
test_table()
{
  constexpr std::array<double, 6> expected = {
    {0.868993, 1.609886, 2.798198, 2.238280, 1.956939, 1.630370}};
  // The error is linear in the step, and quadratic behind that.
  const auto one = stretch(1000), half = stretch(2000), quarter = stretch(4000);
  double error = 0, of_step = 0;
  for (unsigned int i = 0; i < expected.size(); ++i)
    {
      const double first  = 2 * half[i] - one[i],
                   second = 2 * quarter[i] - half[i];
      error = std::max(error, std::abs((4 * second - first) / 3 - expected[i]));
      of_step = std::max(of_step, std::abs(one[i] - expected[i]));
    }
  check_below("bar: extrapolated to steps of no length", error, 1e-6);
  check_below("  steps of 0.001", of_step, 1e-3);
}


void
test_small_and_sudden()
{
  const Hooke at_once(5, 0.3);
  const Relaxation::Terms terms = {{0.3, 0.5}, {0.2, 4}};
  const auto elastic =
    std::make_shared<const MooneyRivlin>(at_once, Form::ciarlet, 0.3);
  const FiniteViscoelasticity law(elastic, at_once, terms);
  const Relaxation relaxation{terms, {}};
  const Viscoelasticity linear(
    std::make_shared<const LinearElasticity>(relaxation.long_after(at_once)),
    at_once,
    relaxation);
  Tensor<2, 3> gradient;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      gradient[i][j] = std::sin(1. + 3 * i + 5 * j);
  std::vector<double> after, of_linear;
  const auto sudden  = evaluate(law, 0.3 * gradient, at_rest(law), after);
  const auto without = elastic->respond(0.3 * gradient);
  check_below(
    "sudden strain: stress", (sudden.stress - without.stress).norm(), 1e-13);
  check_below("  energy",
              std::abs(sudden.energy.total() - without.energy.total()),
              1e-13);

  // Held for a time in small steps.
  constexpr double size      = 1e-6;
  constexpr unsigned int n   = 2000;
  std::vector<double> before = at_rest(law), before_linear = at_rest(linear);
  MaterialResponse finite, small;
  for (unsigned int step = 0; step <= n; ++step)
    {
      const double duration = step == 0 ? 0 : 1. / n;
      finite = evaluate(law, size * gradient, before, after, duration);
      small =
        evaluate(linear, size * gradient, before_linear, of_linear, duration);
      before        = after;
      before_linear = of_linear;
    }
  check_below("small strain: stress",
              (finite.stress - small.stress).norm() / small.stress.norm(),
              1e-3);
  check_below("  energy is kept or heat",
              std::abs(finite.energy.total() / small.energy.total() - 1),
              1e-3);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_table();
    test_small_and_sudden();
    const Hooke at_once(5, 0.3);
    for (const double duration : {0., 0.3, 20.})
      {
        for (const double share : {0., 0.4})
          test_derivatives(
            FiniteViscoelasticity(std::make_shared<const MooneyRivlin>(
                                    at_once, Form::ciarlet, share),
                                  at_once,
                                  {{0.3, 0.1}, {0.2, 4}}),
            duration,
            0.4);
        test_derivatives(
          FiniteViscoelasticity(
            std::make_shared<const Ogden>(
              at_once, Form::quadratic, Ogden::Terms{{1, 3}, {-0.2, -2}}),
            at_once,
            {{0.5, 1}}),
          duration,
          0.4);
      }
  });
}
