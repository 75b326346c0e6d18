// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement gradients: those of a linear displacement are exact on distorted
// and on curved elements; and the extremes of deformed states.

#include <setsudan/mechanics/stress/deformation_extremes.h>
#include <setsudan/mechanics/stress/stress_evaluator.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

#include "../test_setup.h"
#include "small_model.h"

using namespace Setsudan;
using namespace dealii;

template <int dim>
Tensor<2, dim>
some_gradient()
{
  Tensor<2, dim> gradient;
  for (unsigned int a = 0; a < dim; ++a)
    for (unsigned int b = 0; b < dim; ++b)
      gradient[a][b] = 0.1 * (a + 1) - 0.05 * b * b;
  return gradient;
}


/** The gradient at all points, and the extremes that follow from it. */
template <int dim>
void
test_linear(const CoarseMesh<dim> &mesh)
{
  const Discretization<dim> discretization(mesh, {}, MPI_COMM_WORLD);
  const Tensor<2, dim> gradient = some_gradient<dim>();
  const LA::Vector u            = discretization.with_ghosts(nodal_values(
    discretization, [&](const Point<dim> &p) { return gradient * p; }));
  const auto material           = material_of(mesh, 5., 0.3);
  double error = 0, farthest = 0;
  for (const auto &quadrature :
       {node_points(discretization), gauss_points(discretization)})
    {
      StressEvaluator<dim> recovery(discretization, material, quadrature);
      for (const auto &cell :
           discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            recovery.reinit(cell, u);
            for (unsigned int p = 0; p < recovery.n_points(); ++p)
              error =
                std::max(error,
                         (recovery.gradient(p) - gradient).norm() +
                           (recovery.strain(p) - symmetrize(gradient)).norm());
          }
    }
  check_below_on_all("gradient", error);

  const Hooke &hooke   = material.of_element(0).at_rest;
  const auto extremes  = find_extremes(discretization, material, u);
  const auto principal = eigenvalues(symmetrize(gradient));
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    for (const auto &node : mesh.node_positions(cell))
      farthest = std::max(farthest, (gradient * node).norm());
  check_below_on_all(
    "smallest determinant",
    std::abs(extremes.min_jacobian -
             determinant(gradient + unit_symmetric_tensor<dim>())));
  check_below_on_all("largest strain",
                     std::abs(extremes.max_strain -
                              std::max(principal[0], -principal[dim - 1])));
  check_below_on_all("largest maximum shear",
                     std::abs(extremes.max_shear - maximum_shear(hooke.stress(
                                                     symmetrize(gradient)))));
  check_below_on_all("largest displacement",
                     std::abs(extremes.max_displacement - farthest));
}


/** u_x = a x^2 on the unit cube: the determinant is 1 + 2 a x, the strain
 * 2 a x, and the last Gauss point lies at (1 + sqrt(3/5)) / 2. */
void
test_extremes(const double a)
{
  const auto mesh =
    SmallBody<3>({"Body/Size=1, 1, 1", "Body/Elements=1, 2, 2"}).body.mesh;
  const Discretization<3> discretization(mesh, {}, MPI_COMM_WORLD);
  const LA::Vector u  = nodal_values(discretization, [a](const Point<3> &p) {
    return Point<3>(a * p[0] * p[0], 0, 0);
  });
  const auto extremes = find_extremes(
    discretization, material_of(mesh, 5., 0.25), discretization.with_ghosts(u));
  const double last_gauss_point = (1 + std::sqrt(0.6)) / 2;
  check_below_on_all("smallest determinant",
                     std::abs(extremes.min_jacobian - std::min(1., 1 + 2 * a)));
  check_below_on_all(
    "largest strain",
    std::abs(extremes.max_strain - std::abs(2 * a) * last_gauss_point));
  // With E = 5 and nu = 1/4 the shear modulus is 2. How exact the maximum
  // shear of equal principal stresses is, hooke.cc tests.
  check_below_on_all(
    "largest maximum shear",
    std::abs(extremes.max_shear - 2 * std::abs(2 * a) * last_gauss_point),
    1e-7);
  check_below_on_all("largest displacement",
                     std::abs(extremes.max_displacement - std::abs(a)));
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_linear(distorted(SmallBody<2>({"Body/Elements=3, 2"}).body.mesh));
    test_linear(distorted(SmallBody<3>({"Body/Elements=2, 3, 2"}).body.mesh));
    test_linear(curved(SmallBody<2>({"Body/Elements=3, 2"}).body.mesh));
    test_linear(curved(SmallBody<3>({"Body/Elements=2, 3, 2"}).body.mesh));
    // Stretched, pressed, and turned inside out.
    for (const double a : {0.3, -0.3, -0.8})
      test_extremes(a);
  });
}
