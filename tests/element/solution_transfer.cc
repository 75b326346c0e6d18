// SPDX-License-Identifier: LGPL-2.1-or-later
// A quadratic displacement survives refinement and coarsening of a distributed
// mesh, hanging nodes included.

#include <setsudan/element/fe_q_serendipity.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>

#include <deal.II/distributed/solution_transfer.h>
#include <deal.II/distributed/tria.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_system.h>

#include <deal.II/grid/grid_generator.h>

#include <deal.II/lac/trilinos_vector.h>

#include <deal.II/numerics/vector_tools.h>

#include <string>

#include "../test_setup.h"
#include "exact_displacements.h"

using namespace Setsudan;
using namespace dealii;
using VectorType = TrilinosWrappers::MPI::Vector;

/** Flag what to refine or to coarsen, as @p flag says, and move the
 * displacement to the new mesh; return its largest error there. */
template <int dim, typename Flag>
double
transfer_error(parallel::distributed::Triangulation<dim> &mesh,
               DoFHandler<dim> &dof_handler,
               const Flag &flag)
{
  const PolynomialDisplacement<dim> exact(1.);
  VectorType distributed(dof_handler.locally_owned_dofs(), MPI_COMM_WORLD);
  VectorTools::interpolate(dof_handler, exact, distributed);
  IndexSet relevant;
  DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
  VectorType ghosted(
    dof_handler.locally_owned_dofs(), relevant, MPI_COMM_WORLD);
  ghosted = distributed;

  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned())
      flag(cell);
  parallel::distributed::SolutionTransfer<dim, VectorType> transfer(
    dof_handler);
  mesh.prepare_coarsening_and_refinement();
  transfer.prepare_for_coarsening_and_refinement(ghosted);
  mesh.execute_coarsening_and_refinement();
  const FESystem<dim> fe(FE_Q_Serendipity<dim>(), dim);
  dof_handler.distribute_dofs(fe);

  VectorType moved(dof_handler.locally_owned_dofs(), MPI_COMM_WORLD);
  transfer.interpolate(moved);
  distributed.reinit(moved);
  VectorTools::interpolate(dof_handler, exact, distributed);
  moved -= distributed;
  return moved.linfty_norm();
}


template <int dim>
void
test()
{
  const bool is_first = is_first_process();
  parallel::distributed::Triangulation<dim> mesh(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_cube(mesh, 2);
  mesh.refine_global(1);
  const FESystem<dim> fe(FE_Q_Serendipity<dim>(), dim);
  DoFHandler<dim> dof_handler(mesh);
  dof_handler.distribute_dofs(fe);

  const auto report = [&](const std::string &step, const double error) {
    const unsigned int n_cells = mesh.n_global_active_cells();
    if (is_first)
      check_below(std::to_string(dim) + "D " + step + ", " +
                    std::to_string(n_cells) + " cells",
                  error,
                  1e-13);
  };
  report("refined", transfer_error(mesh, dof_handler, [](const auto &cell) {
           if (cell->center()[0] < 0.5 && cell->center()[1] < 0.75)
             cell->set_refine_flag();
         }));
  report("coarsened", transfer_error(mesh, dof_handler, [](const auto &cell) {
           if (cell->center()[0] > 0.25)
             cell->set_coarsen_flag();
         }));
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test<2>();
    test<3>();
  });
}
