// SPDX-License-Identifier: LGPL-2.1-or-later
// The load factor at which a row yields, against closed forms.

#include <setsudan/cut/yield/cutting_stress.h>

#include "../test_setup.h"

using namespace Setsudan;

dealii::SymmetricTensor<2, 3>
shear(const double tau)
{
  dealii::SymmetricTensor<2, 3> stress;
  stress[0][1] = tau;
  return stress;
}

void
check(const std::string &name,
      const FrontStresses &base,
      const FrontStresses &per_load,
      const double sharpness,
      const double max_factor,
      const double expected)
{
  const auto load = find_yield_load(
    [&](const double factor) {
      return cutting_stress(YieldParameters::Criterion::maximum_shear,
                            superpose(base, per_load, factor),
                            sharpness,
                            MPI_COMM_WORLD);
    },
    max_factor);
  check_below(
    name, std::abs(load.load_factor - expected), 1e-12 * (1 + expected));
  std::cout << "  " << (load.yields ? "yields" : "does not yield") << " at "
            << load.stress.reached << " of " << load.stress.required
            << std::endl;
}

/** All in one material, a blade of sharpness 1/2. */
void
check_one_material(const std::string &name,
                   const std::vector<double> &base,
                   const std::vector<double> &per_load,
                   const double required,
                   const double max_factor,
                   const double expected)
{
  const auto stresses = [&](const std::vector<double> &shears) {
    FrontStresses result;
    for (const double tau : shears)
      result.samples.push_back({shear(tau), 2 * required});
    return result;
  };
  check(name, stresses(base), stresses(per_load), 0.5, max_factor, expected);
}

int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    check_one_material("proportional", {0}, {0.25}, 0.5, 10, 2);
    check_one_material("beyond the largest factor", {0}, {0.25}, 0.5, 1.9, 1.9);
    check_one_material("stressed before", {0.3}, {0.1}, 0.5, 10, 2);
    // The load first relieves the stress, and then turns it round.
    check_one_material("relieved first", {-0.3}, {0.1}, 0.5, 10, 8);
    check_one_material("yields at rest", {0.6}, {0.1}, 0.5, 10, 0);
    check(
      "nothing is required", {{{shear(0), 1}}}, {{{shear(0.1), 1}}}, 1, 10, 0);
    // Of two elements the one that overtakes the other decides.
    check_one_material("two elements", {0.2, 0}, {0.1, 0.3}, 1.2, 10, 4);
    // Of two materials the weaker one, although its stress is smaller.
    check("two materials",
          {{{shear(0.2), 2}, {shear(0.05), 0.5}}},
          {{{shear(0.2), 2}, {shear(0.1), 0.5}}},
          0.5,
          10,
          2);
    // The stronger one, where its stress is that much larger.
    check("the stronger of two",
          {{{shear(0), 2}, {shear(0), 0.5}}},
          {{{shear(0.5), 2}, {shear(0.1), 0.5}}},
          0.5,
          10,
          2);
    const auto yields = [](const double reached, const double required) {
      return CuttingStress{reached, required}.yields();
    };
    std::cout << "yields() below, at, above: " << yields(0.4, 0.5)
              << yields(0.5, 0.5) << yields(0.6, 0.5) << ", without need "
              << yields(0, 0) << std::endl;
    std::cout << "required: " << requirement(2, 0.25) << std::endl;
  });
}
