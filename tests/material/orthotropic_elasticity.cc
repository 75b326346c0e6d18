// SPDX-License-Identifier: LGPL-2.1-or-later
// Orthotropic elasticity: the compliance that its constants define, moduli at
// an angle to the axes (closed forms, and Sitka spruce along and across the
// fibres), isotropic constants, stress and tangent as derivatives of the
// energy; and limits by the normal of a cut.

#include <setsudan/material/cut_limit.h>
#include <setsudan/material/orthotropic_elasticity.h>

#include <array>
#include <cmath>

#include "law_at_point.h"

using namespace Setsudan;
using namespace dealii;

MaterialAxes
turned_about_z(const double degrees)
{
  const double angle = degrees * numbers::PI / 180;
  const double c = std::cos(angle), s = std::sin(angle);
  return *find_axes({{c, s, 0}}, {{-s, c, 0}});
}


const MaterialAxes askew = *find_axes({{1, 2, -2}}, {{2, 1, 2}});
const OrthotropicConstants some{{{10, 2, 1}},
                                {{0.3, 0.25, 0.04}},
                                {{0.5, 0.4, 0.8}},
                                askew};


/** Under a stress along each axis, and under a shear between two. */
void
test_compliance()
{
  const auto compliance = invert(some.stiffness());
  double error          = 0;
  for (unsigned int i = 0; i < 3; ++i)
    {
      const unsigned int j = (i + 1) % 3;
      const auto strain =
        compliance * symmetrize(outer_product(askew[i], askew[i]));
      const double E = some.youngs_moduli[i];
      error          = std::max(
        {error,
                  std::abs(askew[i] * (strain * askew[i]) - 1 / E),
                  std::abs(askew[j] * (strain * askew[j]) + some.poissons_ratios[i] / E),
                  std::abs(askew[i] * (strain * askew[j]))});
      const auto shear =
        compliance * symmetrize(outer_product(askew[i], askew[j]));
      error = std::max({error,
                        std::abs(askew[i] * (shear * askew[j]) -
                                 1 / (4 * some.shear_moduli[i])),
                        std::abs(askew[i] * (shear * askew[i]))});
    }
  check_below("compliance", error, 1e-14);
}


/** With the stress along x, at an angle to axis 1. */
void
test_angles(const std::string &name,
            const double E_1,
            const double E_2,
            const double G,
            const double nu,
            const std::vector<std::array<double, 3>> &table)
{
  double of_formula = 0, of_table = 0, of_coupling = 0;
  for (const auto &[degrees, modulus, coupling] : table)
    {
      const double c = std::cos(degrees * numbers::PI / 180);
      const double s = std::sin(degrees * numbers::PI / 180);
      const auto compliance =
        invert(OrthotropicConstants{{{E_1, E_2, E_2}},
                                    {{nu, 0.3, nu * E_2 / E_1}},
                                    {{G, G / 2, G}},
                                    turned_about_z(degrees)}
                 .stiffness());
      const double found    = 1 / compliance[0][0][0][0];
      const double expected = 1 / (std::pow(c, 4) / E_1 + std::pow(s, 4) / E_2 +
                                   s * s * c * c * (1 / G - 2 * nu / E_1));
      of_formula = std::max(of_formula, std::abs(found / expected - 1));
      of_table   = std::max(of_table, std::abs(found / modulus - 1));
      if (coupling != 0)
        of_coupling = std::max(
          of_coupling, std::abs(2 * compliance[0][0][0][1] / coupling - 1));
    }
  check_below(name + ": formula", of_formula, 1e-13);
  check_below("  table", of_table, 1e-4);
  check_below("  shear coupling", of_coupling, 1e-5);
}


void
test_isotropic()
{
  double error = 0, mean = 0;
  for (const double nu : {-0.5, 0., 0.3, 0.499})
    {
      const double E = 5, G = E / (2 * (1 + nu));
      const OrthotropicConstants constants{
        {{E, E, E}}, {{nu, nu, nu}}, {{G, G, G}}, askew};
      const Hooke hooke(E, nu);
      SymmetricTensor<2, 3> strain;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          strain[i][j] = std::sin(1 + 3 * i + 5 * j);
      const auto stress = hooke.stress(strain);
      error             = std::max(error,
                       (constants.stiffness() * strain - stress).norm() /
                         stress.norm());
      mean =
        std::max({mean,
                  std::abs(constants.isotropic_mean().lambda - hooke.lambda) /
                    (hooke.lambda + hooke.mu),
                  std::abs(constants.isotropic_mean().mu / hooke.mu - 1)});
    }
  check_below("isotropic constants", error, 1e-12);
  check_below("  their mean", mean, 1e-12);
}


void
test_law(const ConstitutiveLaw &law)
{
  Tensor<2, 3> gradient;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      gradient[i][j] = 0.2 * std::sin(1 + 3 * i + 7 * j);
  std::cout << law.name() << std::endl;
  test_derivatives_at(gradient, law, {});
}


/** A body that is turned with its material has the same energy; one of which
 * the material alone is turned has another. */
void
test_rotation()
{
  const OrthotropicStVenantKirchhoff law(some);
  Tensor<2, 3> stretch = unit_symmetric_tensor<3>();
  stretch[0][0]        = 1.3;
  stretch[0][1]        = 0.2;
  Tensor<2, 3> turn;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int d = 0; d < 3; ++d)
      turn[i][d] = turned_about_z(40)[d][i];
  const auto energy = [&](const Tensor<2, 3> &F) {
    return law.respond(F - unit_symmetric_tensor<3>()).energy.stored;
  };
  check_below("turned with its material",
              std::abs(energy(turn * stretch) / energy(stretch) - 1),
              1e-13);
  std::cout << "  without: " << energy(stretch * turn) / energy(stretch)
            << std::endl;
}


/** A Poisson's ratio next to the largest, nu12^2 E2 < E1, and three that only
 * together are too large. */
void
test_definiteness()
{
  const auto is_definite =
    [](const double nu_12, const double nu_23, const double nu_31) {
      return OrthotropicConstants{
        {{9, 1, 1}}, {{nu_12, nu_23, nu_31}}, {{1, 1, 1}}, askew}
        .are_definite();
    };
  std::cout << "definite: " << is_definite(2.99, 0, 0)
            << is_definite(3.01, 0, 0) << is_definite(0, 0, 0.33)
            << is_definite(0, 0, 0.34) << is_definite(1.5, 0.49, 1.5 / 9)
            << is_definite(1.5, 0.51, 1.5 / 9) << std::endl;
}


void
test_axes()
{
  const auto number_of = [](const std::array<double, 3> &a,
                            const std::array<double, 3> &b) {
    return find_axes(a, b).has_value();
  };
  std::cout << "axes: " << number_of({{2, 0, 0}}, {{0, 0, 3}})
            << number_of({{1, 0, 0}}, {{0.0005, 1, 0}})
            << number_of({{1, 0, 0}}, {{0.01, 1, 0}})
            << number_of({{0, 0, 0}}, {{0, 1, 0}})
            << number_of({{1, 0, 0}}, {{0, 0, 0}}) << std::endl;
  double error = 0;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      error = std::max(error, std::abs(askew[i] * askew[j] - (i == j)));
  check_below("  right angles", error, 1e-15);
  check_below("  right-handed",
              (cross_product_3d(askew[0], askew[1]) - askew[2]).norm(),
              1e-15);
}


void
test_limits()
{
  const CutLimit limit({{8, 2, 1}}, askew);
  double error = 0;
  for (unsigned int i = 0; i < 3; ++i)
    error = std::max(
      error,
      std::abs(limit.across(askew[i]) - std::array<double, 3>{{8, 2, 1}}[i]));
  const Tensor<1, 3> between = (askew[0] - askew[1]) / std::sqrt(2);
  check_below("limits", error, 1e-14);
  check_below(
    "  between axes 1 and 2", std::abs(limit.across(between) - 5), 1e-14);
  check_below("  smallest", std::abs(limit.smallest(3) - 1), 1e-14);
  const CutLimit in_plane({{8, 2, 1}}, turned_about_z(30));
  check_below("  in the plane",
              std::abs(in_plane.smallest(2) - 2) +
                std::abs(in_plane.across(Tensor<1, 2>({0, 1})) - 3.5),
              1e-14);
  CutLimit sum(3);
  std::cout << "  the same everywhere: " << sum.across(between) << std::endl;
  sum.add(2, limit);
  check_below("  sum", std::abs(sum.across(between) - 13), 1e-14);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_compliance();
    test_angles("E1 = 10, E2 = 1, G = 0.5, nu12 = 0.3",
                10,
                1,
                0.5,
                0.3,
                {{{0, 10, 0}},
                 {{15, 4.699501, -0.406865}},
                 {{30, 2.072539, -0.571577}},
                 {{45, 1.315789, -0.45}},
                 {{60, 1.072386, -0.207846}},
                 {{75, 1.00785, 0}},
                 {{90, 1, 0}}});
    // In MPa; E of slow tests and G of ultrasound.
    test_angles("Sitka spruce",
                9050,
                403,
                1095,
                0.467,
                {{{0, 9050, 0}},
                 {{10, 7699.5, 0}},
                 {{20, 4907.1, 0}},
                 {{30, 2709.1, 0}},
                 {{45, 1175.8, 0}},
                 {{60, 643.3, 0}},
                 {{90, 403, 0}}});
    test_isotropic();
    test_law(OrthotropicElasticity(some));
    test_law(OrthotropicStVenantKirchhoff(some));
    test_rotation();
    test_definiteness();
    test_axes();
    test_limits();
  });
}
