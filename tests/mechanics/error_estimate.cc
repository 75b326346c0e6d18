// SPDX-License-Identifier: LGPL-2.1-or-later
// The estimated error of Lamé's tube under inner pressure against its exact
// error: the estimate's effectivity (estimated over exact energy norm) comes
// near to 1, in 2D and 3D, for nearly incompressible bodies too, and where
// elements are refined locally, and for all types of elements; and a linear
// stress is recovered exactly.

#include <setsudan/mechanics/stress/error_estimate.h>

#include <deal.II/base/mpi.h>

#include <cmath>

#include "../test_setup.h"
#include "solved_model.h"

using namespace Setsudan;
using namespace dealii;

const double inner = 1, outer = 2, pressure = 0.3;

/** A quarter of the tube: a box whose x is r - 1 and whose y is the angle. */
template <int dim>
CoarseMesh<dim>
bent(CoarseMesh<dim> mesh)
{
  const auto bend = [](const Point<dim> &p) {
    Point<dim> q = p;
    q[0]         = (inner + p[0]) * std::cos(p[1]);
    q[1]         = (inner + p[0]) * std::sin(p[1]);
    return q;
  };
  constexpr unsigned int n_corners = GeometryInfo<dim>::vertices_per_cell;
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    {
      typename CoarseMesh<dim>::LineNodes nodes;
      for (unsigned int line = 0; line < nodes.size(); ++line)
        {
          const auto ends = vertices_of_node<dim>(n_corners + line);
          nodes[line] =
            bend(mesh.vertices[mesh.cells[cell].vertices[ends[0]]] +
                 0.5 * (mesh.vertices[mesh.cells[cell].vertices[ends[1]]] -
                        mesh.vertices[mesh.cells[cell].vertices[ends[0]]]));
        }
      mesh.line_nodes.push_back(nodes);
    }
  for (auto &vertex : mesh.vertices)
    vertex = bend(vertex);
  return mesh;
}


SymmetricTensor<2, 3>
exact_stress(const double x, const double y, const double nu)
{
  const double r2 = x * x + y * y, b2 = outer * outer;
  const double p      = pressure * inner * inner / (b2 - inner * inner);
  const double radial = p * (1 - b2 / r2), hoop = p * (1 + b2 / r2);
  SymmetricTensor<2, 3> stress;
  stress[0][0] = (radial * x * x + hoop * y * y) / r2;
  stress[1][1] = (radial * y * y + hoop * x * x) / r2;
  stress[0][1] = (radial - hoop) * x * y / r2;
  stress[2][2] = nu * (radial + hoop);
  return stress;
}


double
density(const Hooke &hooke, const SymmetricTensor<2, 3> &stress)
{
  const auto shear = deviator(stress);
  return shear * shear / (2 * hooke.mu) +
         std::pow(trace(stress) / 3, 2) / (hooke.lambda + 2 * hooke.mu / 3);
}


template <int dim>
void
test_tube(const unsigned int n,
          const double nu,
          const Refinement &refinement = {},
          const std::string &type      = "serendipity")
{
  const std::string m         = std::to_string(n);
  const Parameters parameters = parameters_of(
    {dim == 2 ? "Body/Size=1, 1.5707963267948966"
              : "Body/Size=1, 1.5707963267948966, 1",
     "Body/Element type=" + type,
     "Body/Elements=" + m + ", " + m + (dim == 3 ? ", 1" : ""),
     "Material/Poisson's ratio=" + short_text(nu),
     dim == 2 ? "Support/Fixed components=bottom : y; top : x"
              : "Support/Fixed components=front : y; back : x; bottom : z; "
                "top : z",
     "Load/Pressures=left : " + short_text(pressure)},
    SolvedModel<dim>::declare);
  const auto mesh = bent(SmallBody<dim>(parameters).body.mesh);
  const SolvedModel<dim> solved(parameters, mesh, refinement);
  const auto &model          = solved.model;
  const auto &discretization = model.discretization;
  const LA::Vector u         = discretization.with_ghosts(solved.displacement);
  const auto estimate =
    estimate_error(model, RecoveredStress<dim>(model, u), u);

  StressEvaluator<dim> recovery(
    discretization, model.materials, QGauss<dim>(4));
  const Hooke &hooke = model.materials.of_element(0).at_rest;
  double error = 0, energy = 0;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        recovery.reinit(cell, u);
        for (unsigned int p = 0; p < recovery.n_points(); ++p)
          {
            const auto exact =
              exact_stress(recovery.point(p)[0], recovery.point(p)[1], nu);
            error +=
              density(hooke, recovery.stress(p) - exact) * recovery.volume(p);
            energy += density(hooke, exact) * recovery.volume(p);
          }
      }
  const double exact = std::sqrt(Utilities::MPI::sum(error, MPI_COMM_WORLD) /
                                 Utilities::MPI::sum(energy, MPI_COMM_WORLD));
  const double estimated = std::sqrt(estimate.relative_energy);
  if (is_first_process())
    std::cout << dim << "D, " << type << ", n = " << n << ", nu = " << nu
              << ": " << discretization.triangulation.n_global_active_cells()
              << " cells, error " << exact << ", effectivity "
              << estimated / exact
              << (estimated / exact > 0.7 && estimated / exact < 1.5
                    ? ""
                    : " FAILED")
              << std::endl;
}


/** A bar under its own weight: the stress is linear. */
void
test_linear_stress()
{
  const SolvedModel<3> solved({"Body/Elements=2, 2, 3",
                               "Material/Poisson's ratio=0",
                               "Support/Fixed components=bottom : xyz",
                               "Load/Body force=0, 0, -1"});
  const LA::Vector u =
    solved.model.discretization.with_ghosts(solved.displacement);
  const double error =
    estimate_error(solved.model, RecoveredStress<3>(solved.model, u), u)
      .relative_energy;
  if (is_first_process())
    check_below("linear stress", error, 1e-20);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    std::cout << std::setprecision(4);
    test_linear_stress();
    for (const unsigned int n : {8, 16, 32})
      test_tube<2>(n, 0.3);
    test_tube<2>(16, 0.4999);
    test_tube<2>(8, 0.3, {0, {{0, 1}, {1, 1}, {9, 1}}});
    test_tube<3>(8, 0.3);
    for (const std::string type : {"linear", "quadratic"})
      {
        test_tube<2>(16, 0.3, {}, type);
        test_tube<2>(32, 0.3, {}, type);
        test_tube<2>(32, 0.4999, {}, type);
        test_tube<3>(16, 0.3, {}, type);
      }
  });
}
