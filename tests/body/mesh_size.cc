// SPDX-License-Identifier: LGPL-2.1-or-later
// The size of a mesh and of its refinements, counted and not made: the unknowns
// that deal.II then has.

#include <setsudan/body/mesh_size.h>
#include <setsudan/space/discretization.h>

#include "../parameters/check.h"
#include "../test_setup.h"
#include "small_body.h"

using namespace Setsudan;

template <int dim>
void
test(const std::string &n_elements)
{
  const SmallBody<dim> small({"Body/Elements=" + n_elements});
  MeshSize<dim> mesh = size_of_mesh(small.body.mesh);
  check("a box is counted as its mesh",
        mesh.n_parts == size_of_box<dim>(small.body.box->n_elements).n_parts);
  for (unsigned int level = 0; level < 3; ++level, mesh = mesh.refined())
    for (const auto type : {ElementType::linear,
                            ElementType::serendipity,
                            ElementType::quadratic})
      {
        const Discretization<dim> made(
          small.body.mesh, {level, {}}, MPI_COMM_WORLD, type);
        if (mesh.n_cells() != made.triangulation.n_active_cells() ||
            mesh.n_unknowns(type) != made.dof_handler.n_dofs())
          std::cout << "FAILED: ";
        std::cout << dim << "D, level " << level << ": " << mesh.n_cells()
                  << " cells, " << mesh.n_unknowns(type) << " unknowns"
                  << std::endl;
      }
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test<2>("3, 2");
    test<3>("2, 1, 3");
    std::cout << text_of_memory(1.2e6) << ", " << text_of_memory(2.1e9)
              << std::endl;
    check("a factor takes memory",
          memory_of_model<3>(1e5, true) > 5 * memory_of_model<3>(1e5, false));
  });
}
