// SPDX-License-Identifier: LGPL-2.1-or-later
// Patch test across two levels of hanging nodes, on any number of processes:
// linear displacements on distorted cells and quadratic ones on parallelepipeds
// are reproduced exactly.

#include <setsudan/element/fe_q_serendipity.h>

#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "../test_setup.h"
#include "exact_displacements.h"
#include "small_elasticity.h"

using namespace Setsudan;
using namespace dealii;

template <int dim>
using Mesh = parallel::distributed::Triangulation<dim>;

template <int dim>
std::array<Tensor<1, dim>, dim>
edges()
{
  std::array<Tensor<1, dim>, dim> result;
  for (unsigned int a = 0; a < dim; ++a)
    for (unsigned int b = 0; b < dim; ++b)
      result[a][b] = a == b ? 1. : 0.3 - 0.2 * a;
  return result;
}


/** Move the vertices, so that no face is plane and no edges are parallel. */
template <int dim>
Point<dim>
distort(const Point<dim> &p)
{
  Point<dim> moved = p;
  for (unsigned int d = 0; d < dim; ++d)
    moved[d] += 0.05 * std::sin(5. * p.square() + 2. * d);
  return moved;
}


/** A parallelepiped of three cells per direction. The middle one is refined,
 * then its child that touches the coarse cells' common corner, which makes
 * the library refine the other cells there and leaves levels 0, 1 and 2. */
template <int dim>
void
make_mesh(Mesh<dim> &mesh, const bool is_distorted)
{
  GridGenerator::subdivided_parallelepiped<dim, dim>(
    mesh, Point<dim>(), edges<dim>(), std::vector<unsigned int>(dim, 3));
  Point<dim> refined_point;
  for (const Tensor<1, dim> &edge : edges<dim>())
    refined_point += 0.4 * edge;
  if (is_distorted)
    {
      GridTools::transform(&distort<dim>, mesh);
      refined_point = distort(refined_point);
    }

  for (unsigned int k = 0; k < 2; ++k)
    {
      for (const auto &cell : mesh.active_cell_iterators())
        if (cell->is_locally_owned() && cell->point_inside(refined_point))
          cell->set_refine_flag();
      mesh.execute_coarsening_and_refinement();
    }
}


/** The hanging unknowns, counted by the processes that own them. */
template <int dim>
unsigned int
n_hanging(const SmallElasticity<dim> &body)
{
  unsigned int n = 0;
  for (const auto index : body.owned)
    if (body.constraints.is_constrained(index))
      ++n;
  return Utilities::MPI::sum(n, MPI_COMM_WORLD);
}


template <int dim>
void
test(const bool is_distorted)
{
  Mesh<dim> mesh(MPI_COMM_WORLD);
  make_mesh(mesh, is_distorted);
  const SmallMaterial material{1.5, 1.};
  SmallElasticity<dim> body(mesh, FE_Q_Serendipity<dim>(), material);
  const unsigned int n_hanging_dofs = n_hanging(body);
  const PolynomialDisplacement<dim> exact(is_distorted ? 0. : 1.);
  body.solve(exact,
             Functions::ConstantFunction<dim>(exact.body_force(material)));

  const double error         = body.nodal_error(exact);
  const unsigned int n_cells = mesh.n_global_active_cells();
  if (!is_first_process())
    return;
  std::cout << dim << "D, " << (is_distorted ? "distorted" : "parallelepipeds")
            << ": " << mesh.n_global_levels() << " levels, " << n_cells
            << " cells, " << body.dof_handler.n_dofs() << " unknowns, "
            << n_hanging_dofs << " hanging" << std::endl;
  check_below(is_distorted ? "linear displacement" : "quadratic displacement",
              error,
              1e-10);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for (const bool is_distorted : {false, true})
      {
        test<2>(is_distorted);
        test<3>(is_distorted);
      }
  });
}
