// SPDX-License-Identifier: LGPL-2.1-or-later
// The overlap of a cut's walls: a displacement that presses the two sides
// together by a known amount, on one process and on two.

#include <setsudan/cut/seam/wall_overlap.h>
#include <setsudan/simulation/cut_body.h>

#include "../mechanics/small_model.h"
#include "../parameters/check.h"
#include "../test_setup.h"

using namespace Setsudan;

/** How far the right half moves to the left. */
double
shift(const double y)
{
  return 0.1 + 0.02 * y;
}


template <int dim>
void
test(const bool is_tied)
{
  const Assignments assignments{dim == 2 ? "Body/Elements=4,2"
                                         : "Body/Elements=4,2,1",
                                "Support/Fixed faces=left",
                                "Cut/Surfaces=x:2"};
  const auto parameters = parameters_of(assignments, Scene<dim>::declare);
  const Scene<dim> scene(parameters);
  CutBody<dim> body(scene, MPI_COMM_WORLD);
  body.begin_cut(scene.cut.cuts[0]);
  body.split_nodes();
  if (!is_tied)
    body.finish_cut();
  const auto &discretization = body.model().discretization;
  LA::Vector u               = discretization.zero_vector();
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned() && cell->center()[0] > 5)
      {
        const auto positions = discretization.node_positions(cell);
        const auto nodes     = discretization.node_indices(cell);
        for (unsigned int n = 0; n < nodes.size(); ++n)
          if (u.in_local_range(nodes[n][0]))
            u(nodes[n][0]) = -shift(positions[n][1]);
      }
  u.compress(dealii::VectorOperation::insert);
  const auto overlap = find_wall_overlap(body.walls(), u, MPI_COMM_WORLD);
  if (is_first_process())
    std::cout << dim << "D" << (is_tied ? ", tied" : "") << ": "
              << overlap.depth << " at x = " << overlap.position[0]
              << ", y = " << overlap.position[1] << ", cut " << overlap.cut
              << std::endl;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for (const bool is_tied : {false, true})
      {
        test<2>(is_tied);
        test<3>(is_tied);
      }
  });
}
