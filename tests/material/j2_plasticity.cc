// SPDX-License-Identifier: LGPL-2.1-or-later
// J2 plasticity along a path of plane strain with known stresses (the plane
// strain element of NAFEMS, radial return with one step to each point and with
// many), in a bar, and its stress and tangent as derivatives of its energy.

#include <setsudan/material/j2_plasticity.h>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "law_at_point.h"

using namespace Setsudan;
using namespace dealii;

// MPa.
constexpr double E = 250e3, nu = 0.25, yield_stress = 5;


// Strains along x and y, in 1e-4.
constexpr std::array<std::array<double, 2>, 8> path = {{{{0.25, 0}},
                                                        {{0.5, 0}},
                                                        {{0.5, 0.25}},
                                                        {{0.5, 0.5}},
                                                        {{0.25, 0.5}},
                                                        {{0, 0.5}},
                                                        {{0, 0.25}},
                                                        {{0, 0}}}};
using Stresses = std::array<std::array<double, 3>, 8>;

/** The stresses along x, y and z at the points of the path [MPa], each of which
 * is reached in so many steps of the law. */
Stresses
stresses_on_path(const J2Plasticity &law, const unsigned int n_steps)
{
  Stresses stresses;
  std::vector<double> internal = at_rest(law), after;
  std::array<double, 2> from   = {{0, 0}};
  for (unsigned int point = 0; point < path.size(); ++point)
    {
      for (unsigned int step = 1; step <= n_steps; ++step)
        {
          Tensor<2, 3> gradient;
          for (unsigned int d = 0; d < 2; ++d)
            gradient[d][d] =
              1e-4 * (from[d] + step * (path[point][d] - from[d]) / n_steps);
          const auto stress = evaluate(law, gradient, internal, after).stress;
          for (unsigned int d = 0; d < 3; ++d)
            stresses[point][d] = stress[d][d];
          internal = after;
        }
      from = path[point];
    }
  return stresses;
}


double
largest_difference(const Stresses &stresses, const Stresses &others)
{
  double largest = 0;
  for (unsigned int point = 0; point < path.size(); ++point)
    for (unsigned int d = 0; d < 3; ++d)
      largest =
        std::max(largest, std::abs(stresses[point][d] - others[point][d]));
  return largest;
}


void
test_path(const std::string &name,
          const double isotropic,
          const Stresses &expected)
{
  const J2Plasticity law(Hooke(E, nu), yield_stress, {isotropic, 0});
  check_below(name + ": stresses",
              largest_difference(stresses_on_path(law, 1), expected),
              0.6e-4);
  auto internal = at_rest(law);
  double excess = 0;
  for (const auto &strains : path)
    {
      Tensor<2, 3> gradient;
      for (unsigned int d = 0; d < 2; ++d)
        gradient[d][d] = 1e-4 * strains[d];
      std::vector<double> after;
      const auto stress  = evaluate(law, gradient, internal, after).stress;
      const double mises = std::sqrt(1.5) * deviator(symmetrize(stress)).norm();
      excess =
        std::max(excess, mises - yield_stress - isotropic * after.back());
      internal = after;
      // What has been accepted stays as it is.
      const auto again = evaluate(law, gradient, internal, after);
      excess           = std::max({excess,
                                   (again.stress - stress).norm(),
                                   std::abs(after.back() - internal.back())});
    }
  check_below(
    "  beyond the limit, or other than when it was accepted", excess, 1e-11);
}


/** Without hardening, with more and more steps to each point: the exact
 * stresses are approached in the first order. The lines are the table of
 * doc/published.md.
 *
 * @param exact by an independent program, to four decimals. */
void
test_steps(const Stresses &exact)
{
  const J2Plasticity law(Hooke(E, nu), yield_stress, {0, 0});
  std::map<unsigned int, double> errors;
  for (const unsigned int n_steps : {1, 10, 100, 1000})
    {
      const Stresses stresses = stresses_on_path(law, n_steps);
      errors[n_steps]         = largest_difference(stresses, exact);
      for (unsigned int point = 0; point < path.size(); ++point)
        {
          std::cout << "path " << n_steps << " " << point + 1;
          for (const double stress : stresses[point])
            std::cout << " " << stress;
          std::cout << std::endl;
        }
    }
  check_below("1000 steps to a point: stresses", errors[1000], 1e-3);
  check_below("  order", std::abs(errors[10] / errors[100] / 10 - 1), 0.15);
}


/** A bar that is pulled, released, and pressed to yield again: with kinematic
 * hardening that is at a stress that is lower by twice the yield stress. */
void
test_bar(const Hardening &hardening)
{
  const J2Plasticity law(Hooke(E, nu), yield_stress, hardening);
  const double H = hardening.isotropic + hardening.kinematic;
  // Strains across the bar that leave it free of stress there.
  const auto pull = [&](const double strain,
                        const std::vector<double> &before,
                        std::vector<double> &after) {
    Tensor<2, 3> gradient;
    gradient[0][0] = strain;
    MaterialResponse response;
    for (unsigned int i = 0; i < 30; ++i)
      {
        response       = evaluate(law, gradient, before, after);
        const auto &of = response.tangent;
        const double change =
          response.stress[1][1] / (of[1][1][1][1] + of[1][1][2][2]);
        gradient[1][1] = gradient[2][2] = gradient[1][1] - change;
      }
    return response;
  };
  std::vector<double> pulled, released, pressed;
  const double first = yield_stress / E, largest = 4 * first;
  const auto at_largest = pull(largest, at_rest(law), pulled);
  const double stress   = yield_stress + E * H / (E + H) * (largest - first);
  check_below("pulled", std::abs(at_largest.stress[0][0] - stress), 1e-9);
  check_below("  plastic strain",
              std::abs(pulled[0] - (largest - stress / E)) / largest,
              1e-11);
  const auto at_zero = pull(pulled[0], pulled, released);
  check_below("  released: stress", std::abs(at_zero.stress[0][0]), 1e-9);
  check_below("  released: stored energy",
              std::abs(at_zero.energy.potential - at_zero.energy.plastic),
              1e-15);
  const double left = at_largest.energy.potential - stress * stress / (2 * E);
  check_below("  plastic energy: the area below the curve",
              std::abs(at_zero.energy.plastic / left - 1),
              1e-10);
  const double area =
    yield_stress * first / 2 + (yield_stress + stress) / 2 * (largest - first);
  check_below("  energy: the area",
              std::abs(at_largest.energy.potential / area - 1),
              1e-10);
  // To the other end of the elastic range, and a little further.
  const double range = 2 * (yield_stress + hardening.isotropic * pulled[6]);
  for (const double beyond : {-1e-3, 1e-3})
    {
      pull(largest - range / E * (1 + beyond), pulled, pressed);
      check_below(beyond > 0 ? "  flows back" : "  does not flow yet",
                  (pressed[6] > pulled[6]) == (beyond > 0) ? 0 : 1,
                  0);
    }
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_path("perfect",
              0,
              {{{{7.5, 2.5, 2.5}},
                {{11.6667, 6.6667, 6.6667}},
                {{14.1667, 14.1667, 9.1667}},
                {{16.6667, 19.5534, 13.7799}},
                {{10.1430, 15.7198, 11.6373}},
                {{5.2537, 10.9778, 8.7684}},
                {{2.7537, 3.4778, 6.2684}},
                {{0.1877, -2.9760, 2.7883}}}});
    test_path("isotropic hardening",
              62.5e3,
              {{{{7.5, 2.5, 2.5}},
                {{12.2414, 6.3793, 6.3793}},
                {{14.7414, 13.8793, 8.8793}},
                {{17.0861, 20.1062, 12.8077}},
                {{10.0044, 16.8733, 10.6224}},
                {{4.2409, 12.5739, 8.1852}},
                {{1.7409, 5.0739, 5.6852}},
                {{-0.7591, -2.4261, 3.1852}}}});
    test_steps({{{{7.5, 2.5, 2.5}},
                 {{11.6667, 6.6667, 6.6667}},
                 {{14.1667, 14.1667, 9.1667}},
                 {{16.3175, 19.7121, 13.9704}},
                 {{9.8257, 15.5603, 12.1140}},
                 {{5.0976, 10.6445, 9.2579}},
                 {{2.5976, 3.1445, 6.7579}},
                 {{0.2349, -2.9970, 2.7621}}}});
    for (const Hardening &hardening :
         {Hardening{0.2 * E, 0}, Hardening{0, 0.2 * E}, Hardening{2e4, 1e4}})
      test_bar(hardening);
    for (const Hardening &hardening : {Hardening(), Hardening{0.7, 0.4}})
      test_derivatives(J2Plasticity(Hooke(5, 0.3), 1, hardening));
  });
}
