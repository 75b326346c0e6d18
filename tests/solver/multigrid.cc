// Multigrid without a matrix gives what the direct solver gives, in few
// iterations whose number does not grow with the body: for all shapes, elements
// and supports, and hanging nodes. Scenes try ties and materials far apart.

#include <setsudan/solver/multigrid_equilibrium.h>

#include <deal.II/base/mpi.h>

#include <string>

#include "../elasticity/solved_model.h"
#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

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
  AffineConstraints<double> constraints(model.discretization.relevant);
  constraints.merge(model.hanging);
  constraints.merge(model.supports);
  constraints.close();
  MultigridEquilibrium<dim> equilibrium(
    model, constraints, solved.solver_parameters);
  LA::Vector difference = equilibrium.solve(
    model.loads, model.prescribed, model.discretization.zero_vector());
  difference -= solved.displacement;
  const double error =
    difference.linfty_norm() / solved.displacement.linfty_norm();
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return;
  std::cout << dim << "D, " << name << ": "
            << model.discretization.dof_handler.n_dofs() << " unknowns"
            << std::endl;
  check_below("  difference", error, 1e-8);
  check_below("  iterations", equilibrium.n_iterations(), most_iterations);
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
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    compare_all<2>();
    compare_all<3>();
  });
}
