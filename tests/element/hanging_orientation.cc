// SPDX-License-Identifier: LGPL-2.1-or-later
// Hanging nodes on a face that the two cells see in different positions, in
// all eight of them: the constraints give each hanging node the value that a
// quadratic polynomial has there.

#include <setsudan/element/fe_q_serendipity.h>

#include <deal.II/base/function.h>
#include <deal.II/base/point.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/vector.h>

#include <deal.II/numerics/vector_tools.h>

#include <string>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

class Quadratic : public Function<3>
{
public:
  double
  value(const Point<3> &p, const unsigned int) const override
  {
    return 1. + p[0] - 2. * p[1] + 0.5 * p[2] + p[0] * p[1] - p[1] * p[2] +
           p[1] * p[1] + 3. * p[2] * p[2] - p[0] * p[0];
  }
};


/** Two cubes, seen with these flags, one of them refined. */
void
test(const unsigned int flags,
     const bool left_is_turned,
     const bool left_is_refined)
{
  Triangulation<3> triangulation;
  GridGenerator::non_standard_orientation_mesh(
    triangulation, flags & 1U, flags & 2U, flags & 4U, left_is_turned);
  for (const auto &cell : triangulation.active_cell_iterators())
    if ((cell->center()[0] < 1.) == left_is_refined)
      cell->set_refine_flag();
  triangulation.execute_coarsening_and_refinement();

  const FE_Q_Serendipity<3> fe;
  DoFHandler<3> dof_handler(triangulation);
  dof_handler.distribute_dofs(fe);
  AffineConstraints<double> constraints;
  DoFTools::make_hanging_node_constraints(dof_handler, constraints);
  constraints.close();

  Vector<double> exact(dof_handler.n_dofs());
  VectorTools::interpolate(dof_handler, Quadratic(), exact);
  Vector<double> constrained = exact;
  constraints.set_zero(constrained);
  constraints.distribute(constrained);
  constrained -= exact;
  check_below("flags " + std::to_string(flags) + ", left cell " +
                (left_is_turned ? "turned " : "") +
                (left_is_refined ? "refined" : "coarse") + ", " +
                std::to_string(constraints.n_constraints()) + " hanging",
              constrained.linfty_norm(),
              1e-13);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for (unsigned int flags = 0; flags < 8; ++flags)
      for (const bool left_is_turned : {false, true})
        for (const bool left_is_refined : {false, true})
          test(flags, left_is_turned, left_is_refined);
  });
}
