// SPDX-License-Identifier: LGPL-2.1-or-later
// The extremes of a deformed body by the kernels are those that are found cell
// by cell, for all shapes, elements and materials.

#include <setsudan/mechanics/stress/deformation_extremes.h>

#include <cmath>

#include "many_models.h"

using namespace Setsudan;

void
check_same(const char *name, const double fast, const double slow)
{
  check_below(name, std::abs(fast - slow) / std::abs(slow), 1e-12);
}


template <int dim>
void
test_extremes()
{
  for_each_small_model<dim>([](const std::string &name, auto &model) {
    const LA::Vector u = random_displacement(model.discretization);
    const auto fast    = find_extremes(model, u);
    const auto slow    = find_extremes(model.discretization,
                                    model.materials,
                                    model.discretization.with_ghosts(u));
    std::cout << name << std::endl;
    check_same("  determinant", fast.min_jacobian, slow.min_jacobian);
    check_same("  strain", fast.max_strain, slow.max_strain);
    check_same("  shear", fast.max_shear, slow.max_shear);
    check_same("  displacement", fast.max_displacement, slow.max_displacement);
  });
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_extremes<2>();
    test_extremes<3>();
  });
}
