// SPDX-License-Identifier: LGPL-2.1-or-later
// Bars whose displacement is a polynomial that the elements contain: pulled by
// a force F on their end, sigma = F / A, or by a clamp that moves it; standing
// under their own weight, the top sinks by rho g h^2 / (2 E). Without lateral
// contraction, nu = 0, the fixed end does not disturb them.

#include <setsudan/mechanics/balance.h>
#include <setsudan/mechanics/stress/stress_evaluator.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "../test_setup.h"
#include "solved_model.h"

using namespace Setsudan;
using namespace dealii;

const double E = 5., height = 10.;

/** The largest differences from a displacement and a stress along the axis,
 * everything across it being 0, relative to their largest values. */
template <int dim>
void
compare(SolvedModel<dim> &solved,
        const std::function<double(double)> &displacement,
        const std::function<double(double)> &stress)
{
  const auto &discretization = solved.model.discretization;
  const LA::Vector u         = discretization.with_ghosts(solved.displacement);
  StressEvaluator<dim> recovery(
    discretization, solved.material, node_points(discretization));
  double u_error = 0, u_max = 0, stress_error = 0, stress_max = 0;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    {
      recovery.reinit(cell, u);
      const auto nodes     = discretization.node_indices(cell);
      const auto positions = discretization.node_positions(cell);
      for (unsigned int node = 0; node < nodes.size(); ++node)
        {
          const double z = positions[node][dim - 1];
          for (unsigned int c = 0; c < dim; ++c)
            u_error = std::max(u_error,
                               std::abs(u(nodes[node][c]) -
                                        (c == dim - 1 ? displacement(z) : 0.)));
          SymmetricTensor<2, 3> expected;
          expected[dim - 1][dim - 1] = stress(z);
          stress_error =
            std::max(stress_error, (recovery.stress(node) - expected).norm());
          u_max      = std::max(u_max, std::abs(displacement(z)));
          stress_max = std::max(stress_max, std::abs(stress(z)));
        }
    }
  check_below("displacement", u_error / u_max, 1e-12);
  check_below("stress", stress_error / stress_max, 1e-11);
}


template <int dim>
BodyBalance<dim>
balance(SolvedModel<dim> &solved)
{
  auto &model                = solved.model;
  const auto &discretization = model.discretization;
  const LA::Vector internal =
    internal_forces(discretization,
                    model.stiffness,
                    discretization.with_ghosts(solved.displacement));
  return check_balance<dim>(model, internal, model.loads, {});
}


template <int dim>
void
test(const Refinement &refinement)
{
  std::cout << dim << "D" << std::endl;
  Assignments bar = {dim == 3 ? "Body/Size=2, 3, 10" : "Body/Size=2, 10",
                     dim == 3 ? "Body/Elements=2, 1, 3" : "Body/Elements=2, 3",
                     "Material/Young's modulus=5",
                     "Material/Poisson's ratio=0",
                     "Support/Fixed faces=bottom"};

  Assignments pulled = bar;
  pulled.push_back(dim == 3 ? "Load/Tractions=top : 0, 0, 0.25"
                            : "Load/Tractions=top : 0, 0.25");
  SolvedModel<dim> pulled_bar(pulled, refinement);
  compare<dim>(
    pulled_bar,
    [](const double z) { return 0.25 / E * z; },
    [](const double) { return 0.25; });
  std::cout << "reaction " << balance(pulled_bar).reaction[dim - 1]
            << std::endl;

  Assignments pressed = bar;
  pressed.push_back("Load/Pressures=top : 0.25");
  SolvedModel<dim> pressed_bar(pressed, refinement);
  compare<dim>(
    pressed_bar,
    [](const double z) { return -0.25 / E * z; },
    [](const double) { return -0.25; });

  Assignments moved = bar;
  moved.push_back(dim == 3 ? "Support/Displacements=top : free, free, 0.5"
                           : "Support/Displacements=top : free, 0.5");
  SolvedModel<dim> moved_bar(moved, refinement);
  compare<dim>(
    moved_bar,
    [](const double z) { return 0.5 * z / height; },
    [](const double) { return 0.5 * E / height; });
  std::cout << "reaction " << balance(moved_bar).reaction[dim - 1] << ", clamp "
            << balance(moved_bar).clamp_force[dim - 1] << std::endl;

  Assignments heavy = bar;
  heavy.push_back(dim == 3 ? "Load/Body force=0, 0, -0.1"
                           : "Load/Body force=0, -0.1");
  SolvedModel<dim> column(heavy, refinement);
  compare<dim>(
    column,
    [](const double z) { return -0.1 / E * (height * z - z * z / 2); },
    [](const double z) { return -0.1 * (height - z); });
  std::cout << "reaction " << balance(column).reaction[dim - 1]
            << ", the top sinks by " << column.displacement.linfty_norm()
            << std::endl;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test<2>({});
    test<3>({});
    // Refined once, and in the cell at the origin once or twice more: as well
    // where the bar is held, and in the middle.
    std::cout << "refined" << std::endl;
    test<2>({1, {{0, 4}}});
    test<3>({0, {{0, 1}, {0, 15}, {2, 1}}});
  });
}
