// SPDX-License-Identifier: LGPL-2.1-or-later
// K u cell by cell in batches is K u by the cells' matrices, for all shapes,
// elements and materials, and so are the parts of K that are asked for.

#include <setsudan/mechanics/cell_batches.h>
#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/space/reference_gradients.h>

#include <cmath>

#include "many_models.h"

using namespace Setsudan;
using namespace dealii;

/** How far the kernel's matrix of each cell's own functions, and its diagonal,
 * are from the cell's matrix, relative to that. */
template <int dim>
double
difference_of_matrices(ElasticModel<dim> &model)
{
  const auto &batches      = model.batches();
  const auto &fe           = model.discretization.fe;
  const unsigned int n     = fe.n_dofs_per_cell();
  const unsigned int lanes = batches.kernel.n_lanes;
  const auto gradients     = reference_gradients(
    fe.base_element(0), model.discretization.n_gauss_points());
  AlignedVector<double> all(n * n * lanes), diagonal(n * lanes);
  double error            = 0;
  unsigned int first_cell = 0;
  for (unsigned int b = 0; b < batches.size(); ++b)
    {
      const CellBatch batch = batches[b];
      for (const bool is_diagonal : {false, true})
        batches.kernel.integrate(batch,
                                 gradients.data(),
                                 n / dim,
                                 is_diagonal,
                                 is_diagonal ? diagonal.data() : all.data());
      for (unsigned int lane = 0; lane < batch.n_cells; ++lane)
        {
          const auto &matrix =
            model.stiffness(batches.cells()[first_cell + lane]);
          const double scale = matrix.linfty_norm();
          const auto place   = [&](const unsigned int i) {
            const auto [component, node] = fe.system_to_component_index(i);
            return node * dim + component;
          };
          for (unsigned int i = 0; i < n; ++i)
            {
              const double own = diagonal[place(i) * lanes + lane];
              error = std::max(error, std::abs(own - matrix(i, i)) / scale);
              for (unsigned int j = 0; j < n; ++j)
                error = std::max(
                  error,
                  std::abs(all[(place(i) * n + place(j)) * lanes + lane] -
                           matrix(i, j)) /
                    scale);
            }
        }
      first_cell += batch.n_cells;
    }
  return error;
}


template <int dim>
void
test_products()
{
  for_each_small_model<dim>([](const std::string &name, auto &model) {
    const LA::Vector u   = random_displacement(model.discretization);
    LA::Vector forces    = internal_forces(model, u);
    const LA::Vector old = internal_forces(model.discretization,
                                           model.stiffness,
                                           model.discretization.with_ghosts(u));
    forces -= old;
    if (is_first_process())
      std::cout << name << std::endl;
    check_below_on_all(
      "  difference", forces.linfty_norm() / old.linfty_norm(), 1e-14);
    check_below_on_all(
      "  of the matrices", difference_of_matrices(model), 1e-14);
  });
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_products<2>();
    test_products<3>();
  });
}
