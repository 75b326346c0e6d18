// SPDX-License-Identifier: LGPL-2.1-or-later
// The tangent of a deformed body, condensed onto the unknowns on which some
// forces act, against the whole of it: what the forces do to each other,
// springs, and how many eigenvalues are negative.

#include <setsudan/solver/assembled_solver.h>
#include <setsudan/solver/condensed/condensed_tangent.h>
#include <setsudan/solver/linear/mumps_solver.h>

#include <cmath>
#include <string>
#include <vector>

#include "block.h"

using namespace Setsudan;
using namespace dealii;

/** Forces on three unknowns each, some of which are supported. */
std::vector<UnknownForces>
forces_on(const Block &block)
{
  const unsigned int n = block.model.discretization.dof_handler.n_dofs();
  std::vector<UnknownForces> all;
  for (unsigned int v = 0; v < 6; ++v)
    {
      all.emplace_back();
      for (unsigned int i = 0; i < 3; ++i)
        all.back().emplace_back((37 * v + 11 * i) % n, 1. + v - i / 2.);
    }
  return all;
}


void
test_block()
{
  const Block block({"Body/Size=2,2,3",
                     "Body/Elements=2,2,3",
                     "Support/Fixed faces=bottom",
                     "Load/Tractions=top : 0.1, 0, -0.5",
                     "Deformation/Strain=finite",
                     "Solver/Method=direct"});
  const auto &model     = block.model;
  const LA::Vector zero = model.discretization.zero_vector();
  const LA::Vector about =
    nodal_values(model.discretization, [](const Point<3> &p) {
      return Tensor<1, 3>(
        {0.03 * p[2] * p[2], 0.02 * p[2] * p[0], 0.05 * p[2]});
    });
  const auto forces = forces_on(block);

  AssembledSolver<3> whole(model,
                           *block.constraints,
                           block.solver,
                           Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1
                             ? SolverKind::cholesky
                             : SolverKind::mumps);
  whole.linearize({&about});
  CondensedTangent<3> condensed(model, *block.constraints, forces, {});
  condensed.linearize(about);
  SolveQuality quality;
  LA::Vector difference = whole.increment(model.loads, zero, quality);
  const double largest  = difference.linfty_norm();
  difference -= condensed.increment(model.loads);
  check_below_on_all("solution", difference.linfty_norm() / largest, 1e-10);
  const auto products = condensed.products();
  double error = 0, size = 0;
  for (unsigned int v = 0; v < forces.size(); ++v)
    {
      const auto work = work_of(
        forces, whole.increment(vector_of(forces[v], zero), zero, quality));
      for (unsigned int w = 0; w < forces.size(); ++w)
        {
          error = std::max(error, std::abs(products(w, v) - work[w]));
          size  = std::max(size, std::abs(work[w]));
        }
    }
  check_below_on_all("products", error / size, 1e-10);

  CondensedTangent<3> on_springs(model, *block.constraints, {}, forces);
  on_springs.linearize(about);
  const LA::Vector d  = on_springs.increment(model.loads);
  LA::Vector residual = tangent_times(model, about, d);
  residual += spring_forces(forces, d);
  residual -= model.loads;
  check_below_on_all("springs",
                     condense(*block.constraints, residual).l2_norm() /
                       condense(*block.constraints, model.loads).l2_norm(),
                     1e-10);
}


/** Columns that are pressed evenly, beyond the loads at which they buckle, and
 * are held nowhere but at the bottom; and what holds them if the forces' own
 * unknowns do. */
void
test_column(const double strain)
{
  const Block column({"Body/Size=1,1,20",
                      "Body/Elements=1,1,10",
                      "Support/Fixed faces=bottom",
                      "Material/Poisson's ratio=0",
                      "Deformation/Strain=finite"});
  const auto &model = column.model;
  const LA::Vector about =
    nodal_values(model.discretization, [&](const Point<3> &p) {
      return Tensor<1, 3>({0., 0., -strain * p[2]});
    });
  // At the nodes halfway up.
  std::vector<UnknownForces> forces;
  for (unsigned int i = 0; i < model.discretization.dof_handler.n_dofs(); ++i)
    forces.emplace_back(1, std::make_pair(i, 1.));
  const LA::Vector height =
    nodal_values(model.discretization, [](const Point<3> &p) {
      return Tensor<1, 3>({p[2], p[2], p[2]});
    });
  std::vector<UnknownForces> halfway;
  const auto heights = work_of(forces, height);
  for (unsigned int i = 0; i < forces.size(); ++i)
    if (std::abs(heights[i] - 10) < 1e-9)
      halfway.push_back(forces[i]);
  CondensedTangent<3> condensed(model, *column.constraints, halfway, {});
  condensed.linearize(about);
  LA::SparseMatrix matrix;
  assemble_tangent(model, {&about}, *column.constraints, matrix);
  MumpsSolver whole(50, false);
  whole.initialize(matrix, {});
  say("column, strain " + std::to_string(strain) + ": " +
      std::to_string(condensed.n_negative()) + " negative, " +
      std::to_string(whole.n_negative()) + " of the whole");
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_block();
    for (const double strain : {0.0003, 0.0015})
      test_column(strain);
  });
}
