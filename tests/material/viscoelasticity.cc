// SPDX-License-Identifier: LGPL-2.1-or-later
// Viscoelasticity of a standard linear solid against its closed forms:
// relaxation, ramp and creep, what a cycle turns into heat; steps that take no
// time; stress and tangent as derivatives of the energy, with plastic flow too.

#include <setsudan/material/j2_plasticity.h>
#include <setsudan/material/viscoelasticity.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "law_at_point.h"

using namespace Setsudan;
using namespace dealii;

// Young's modulus at once, and what is left of it; the relaxation time.
constexpr double E = 3, lasting = 1, tau = 0.5, nu = 0.3;
constexpr std::array<double, 7> times = {{0, 0.1, 0.25, 0.5, 1, 2, 5}};


std::shared_ptr<const SmallStrainLaw>
make_solid(const Relaxation &relaxation, const double yield_stress = 0)
{
  const Hooke at_once(E, nu), long_after = relaxation.long_after(at_once);
  std::shared_ptr<const SmallStrainLaw> law;
  if (yield_stress > 0)
    law = std::make_shared<const J2Plasticity>(
      long_after, yield_stress, Hardening{0.2, 0.1});
  else
    law = std::make_shared<const LinearElasticity>(long_after);
  return std::make_shared<const Viscoelasticity>(law, at_once, relaxation);
}


/** A bar under uniaxial stress: shear and bulk relax alike. */
class Bar
{
public:
  Bar()
    : law(make_solid({{{(E - lasting) / E, tau}}, {{(E - lasting) / E, tau}}}))
    , internal(at_rest(*law))
  {
  }

  /** Stretch it to a strain; the stress is the answer. */
  double
  stretch(const double strain, const double duration)
  {
    Tensor<2, 3> gradient;
    gradient[0][0] = strain;
    gradient[1][1] = gradient[2][2]  = -nu * strain;
    const std::vector<double> before = internal;
    const auto response = evaluate(*law, gradient, before, internal, duration);
    energy              = response.energy;
    across              = std::abs(response.stress[1][1]);
    return response.stress[0][0];
  }

  Energy energy;
  double across = 0;

private:
  std::shared_ptr<const SmallStrainLaw> law;
  std::vector<double> internal;
};


void
test_relaxation()
{
  constexpr std::array<double, 7> expected = {
    {3, 2.637462, 2.213061, 1.735759, 1.270671, 1.036631, 1.000091}};
  double error = 0, across = 0;
  for (const unsigned int n : {1, 7})
    for (unsigned int i = 0; i < times.size(); ++i)
      {
        Bar bar;
        double stress = bar.stretch(1, 0);
        for (unsigned int step = 0; step < n; ++step)
          stress = bar.stretch(1, times[i] / n);
        error  = std::max(error, std::abs(stress - expected[i]));
        across = std::max(across, bar.across);
      }
  check_below("relaxation", error, 1e-6);
  check_below("  stress across", across, 1e-14);
}


void
test_ramp()
{
  constexpr std::array<double, 7> expected = {
    {0, 0.281269, 0.643469, 1.132121, 1.864665, 2.981684, 5.999955}};
  double error = 0, of_steps = 0, work = 0;
  for (unsigned int i = 1; i < times.size(); ++i)
    {
      const double t = times[i];
      const double exact =
        lasting * t + (E - lasting) * tau * (1 - std::exp(-t / tau));
      // The integral of the stress.
      const double area =
        lasting * t * t / 2 +
        (E - lasting) * tau * (t - tau * (1 - std::exp(-t / tau)));
      for (const unsigned int n : {1, 3, 1000})
        {
          Bar bar;
          double stress = 0;
          for (unsigned int step = 1; step <= n; ++step)
            stress = bar.stretch(step * t / n, t / n);
          error    = std::max(error, std::abs(stress - expected[i]));
          of_steps = std::max(of_steps, std::abs(stress / exact - 1));
          work     = std::max(work, std::abs(bar.energy.total() / area - 1));
        }
    }
  check_below("ramp", error, 1e-6);
  check_below("  at any step", of_steps, 1e-12);
  check_below("  energy: the area below the curve", work, 1e-11);
}


void
test_creep()
{
  constexpr std::array<double, 7> expected = {
    {0.333333, 0.376329, 0.435679, 0.522312, 0.657722, 0.824269, 0.976217}};
  constexpr unsigned int n = 2000;
  double error             = 0;
  for (unsigned int i = 0; i < times.size(); ++i)
    {
      Bar bar;
      double strain = 1 / E;
      bar.stretch(strain, 0);
      for (unsigned int step = 0; step < n && times[i] > 0; ++step)
        {
          // The stress is linear in the strain.
          const double duration = times[i] / n;
          Bar first = bar, second = bar;
          const double at_zero = first.stretch(0, duration),
                       at_one  = second.stretch(1, duration);
          strain               = (1 - at_zero) / (at_one - at_zero);
          bar.stretch(strain, duration);
        }
      error = std::max(error, std::abs(strain - expected[i]));
    }
  check_below("creep", error, 1e-6);
}


void
test_cycles()
{
  // Loss moduli.
  constexpr std::array<std::array<double, 2>, 4> expected = {
    {{{0.1, 0.099751}}, {{1, 0.8}}, {{2, 1}}, {{10, 0.384615}}}};
  constexpr unsigned int n = 2000;
  double error             = 0;
  for (const auto &[frequency, loss] : expected)
    {
      Bar bar;
      const double period = 2 * numbers::PI / frequency;
      double before = 0, heat = 0;
      // Until what was at the beginning is forgotten.
      const unsigned int n_cycles = 2 + 20 * tau / period;
      for (unsigned int cycle = 0; cycle < n_cycles; ++cycle)
        {
          before = bar.energy.viscous;
          for (unsigned int step = 1; step <= n; ++step)
            bar.stretch(std::sin(2 * numbers::PI * step / n), period / n);
          heat = bar.energy.viscous - before;
        }
      error = std::max(error, std::abs(heat / (numbers::PI * loss) - 1));
    }
  check_below("heat of a cycle: pi times the loss modulus", error, 1e-5);
}


/** Without time the body is elastic, and the dashpots stay as they are. */
void
test_no_time()
{
  const auto law = make_solid({{{0.3, 0.1}, {0.2, 4}}, {{0.1, 1}}});
  const Hooke at_once(E, nu);
  std::vector<double> before, after, internal = at_rest(*law);
  Tensor<2, 3> first, second;
  first[0][0]  = 0.3;
  first[1][2]  = 0.2;
  second[2][2] = -0.4;
  second[0][1] = 0.5;
  evaluate(*law, first, internal, before, 0.7);
  const auto from  = evaluate(*law, first, before, after);
  const auto to    = evaluate(*law, second, before, after);
  const auto jump  = at_once.stress(symmetrize(second - first));
  const double off = (symmetrize(to.stress - from.stress) - jump).norm();
  check_below("a jump of the strain: elastic", off, 1e-14);
  double moved = std::abs(after[0] - before[0]);
  // The last strain, of seven numbers, is another one.
  for (unsigned int i = 8; i < before.size(); ++i)
    moved = std::max(moved, std::abs(after[i] - before[i]));
  check_below("  internal variables", moved, 1e-15);
  check_below("  energy is stored",
              std::abs(to.energy.potential - to.energy.total()),
              1e-15);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_relaxation();
    test_ramp();
    test_creep();
    test_cycles();
    test_no_time();
    for (const double yield_stress : {0., 0.2})
      for (const double duration : {0., 1e-9, 0.3, 20.})
        test_derivatives(
          *make_solid({{{0.3, 0.1}, {0.2, 4}}, {{0.1, 1}}}, yield_stress),
          duration);
  });
}
