// SPDX-License-Identifier: LGPL-2.1-or-later
// Multigrid without a matrix gives what the direct solver gives, in few
// iterations whose number does not grow with the body: for all shapes, elements
// and supports, and hanging nodes. Scenes try ties and materials far apart.

#include <setsudan/solver/matrix_free_solver.h>

#include <deal.II/base/mpi.h>

#include <string>

#include "../mechanics/solved_model.h"
#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

/** The constraints of a model, and more of them if asked for. */
template <int dim>
AffineConstraints<double>
constraints_of(const ElasticModel<dim> &model, const bool more)
{
  AffineConstraints<double> constraints(model.discretization.relevant);
  constraints.merge(model.hanging);
  constraints.merge(model.supports);
  if (more)
    for (const auto index : model.discretization.relevant)
      if (index % 50 == 0 && !constraints.is_constrained(index))
        constraints.add_line(index);
  constraints.close();
  return constraints;
}


/** What is kept from other constraints does not change the result, whether it
 * serves or not. */
template <int dim>
void
compare_kept(SolvedModel<dim> &solved, const MatrixFreeSolver<dim> &fresh)
{
  auto &model      = solved.model;
  const auto solve = [&](MatrixFreeSolver<dim> &solver) {
    return solver
      .solve(model.loads, model.lift, model.discretization.zero_vector())
      .displacement;
  };
  const auto few  = constraints_of(model, false);
  const auto many = constraints_of(model, true);
  MatrixFreeSolver<dim> strict(model, many, solved.solver_parameters);
  const LA::Vector held = solve(strict);
  MatrixFreeSolver<dim> kept(model, few, solved.solver_parameters, &strict);
  LA::Vector difference = solve(kept);
  difference -= solved.displacement;
  check_below_on_all("  kept",
                     difference.linfty_norm() /
                       solved.displacement.linfty_norm(),
                     1e-8);
  MatrixFreeSolver<dim> not_kept(model, many, solved.solver_parameters, &fresh);
  difference = solve(not_kept);
  difference -= held;
  check_below_on_all("  not kept",
                     difference.linfty_norm() /
                       solved.displacement.linfty_norm(),
                     1e-8);
}


template <int dim>
void
compare(const std::string &name,
        const unsigned int most_iterations,
        const Assignments &extra,
        const CoarseMesh<dim> *mesh  = nullptr,
        const Refinement &refinement = {})
{
  Assignments assignments{"Support/Fixed faces=left",
                          "Material/Poisson's ratio=0.3",
                          dim == 2 ? "Load/Tractions=right: 1, 2"
                                   : "Load/Tractions=right: 1, 2, -1",
                          "Solver/Method=direct",
                          "Solver/Tolerance=1e-12"};
  assignments.insert(assignments.end(), extra.begin(), extra.end());
  const auto parameters = parameters_of(assignments, SolvedModel<dim>::declare);
  auto solved           = mesh == nullptr
                            ? SolvedModel<dim>(parameters, refinement)
                            : SolvedModel<dim>(parameters, *mesh, refinement);
  auto &model           = solved.model;
  const auto constraints = constraints_of(model, false);
  MatrixFreeSolver<dim> solver(model, constraints, solved.solver_parameters);
  LA::Vector difference =
    solver.solve(model.loads, model.lift, model.discretization.zero_vector())
      .displacement;
  difference -= solved.displacement;
  const double error =
    difference.linfty_norm() / solved.displacement.linfty_norm();
  if (is_first_process())
    std::cout << dim << "D, " << name << ": "
              << model.discretization.dof_handler.n_dofs() << " unknowns"
              << std::endl;
  check_below_on_all("  difference", error, 1e-8);
  check_below_on_all("  iterations", solver.n_iterations(), most_iterations);
  compare_kept(solved, solver);
}


template <int dim>
void
compare_all()
{
  const std::string few =
    "Body/Elements=" + std::string(dim == 2 ? "6,4" : "4,3,3");
  const Assignments box{few};
  compare<dim>("box", 20, box);
  compare<dim>("larger box",
               20,
               {"Body/Elements=" + std::string(dim == 2 ? "24,16" : "8,6,6")});
  const CoarseMesh<dim> mesh = SmallBody<dim>(box).body.mesh;
  const auto uneven = distorted(mesh), bent = curved(distorted(mesh));
  compare<dim>("distorted", 25, box, &uneven);
  compare<dim>("curved", 25, box, &bent);
  compare<dim>("quadratic", 20, {few, "Body/Element type=quadratic"}, &uneven);
  compare<dim>("moved",
               25,
               {few,
                dim == 2 ? "Support/Displacements=right : free, 0.5"
                         : "Support/Displacements=right : free, free, 0.5"},
               &uneven);
  compare<dim>("refined", 25, box, &uneven, {1, {}});
  const Refinement locally = dim == 2 ? Refinement{0, {{1, 1}, {2, 1}}}
                                      : Refinement{1, {{1, 9}, {2, 8}}};
  compare<dim>("hanging nodes", 25, box, &uneven, locally);
  compare<dim>("nearly incompressible",
               80,
               {few, "Material/Poisson's ratio=0.49"},
               &uneven);
  const std::string size = "Body/Size=" + std::string(dim == 2 ? "1" : "1,1");
  compare<dim>("ten times as long", 60, {few, size + ",10"});
  compare<dim>("a hundred times as long", 200, {few, size + ",100"});
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    compare_all<2>();
    compare_all<3>();
  });
}
