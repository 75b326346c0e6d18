// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mechanics/stress/grid_gradients.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
void
visit_gradients(const ElasticModel<dim> &model,
                const typename CellBatches<dim>::Vector &displacement,
                const std::function<void(const GradientsOfBatch &)> &visit)
{
  auto &batches      = model.batches();
  const auto &kernel = batches.kernel;
  const auto gradients_of =
    model.discretization.type == ElementType::serendipity
      ? kernel.serendipity_gradients
      : kernel.quadratic_gradients;
  const double *const positions = batches.positions().begin();
  AlignedVector<double> gradients(2 * Utilities::pow(3, dim) * dim * dim *
                                  kernel.n_lanes);
  unsigned int first = 0;
  for (unsigned int b = 0; b < batches.size(); ++b)
    {
      const CellBatch batch = batches[b];
      gradients_of(batch, positions, displacement.begin(), gradients.data());
      visit({batch, first, kernel.n_lanes, gradients.data()});
      first += batch.n_cells;
    }
}



template void
visit_gradients(const ElasticModel<2> &,
                const CellBatches<2>::Vector &,
                const std::function<void(const GradientsOfBatch &)> &);
template void
visit_gradients(const ElasticModel<3> &,
                const CellBatches<3>::Vector &,
                const std::function<void(const GradientsOfBatch &)> &);
} // namespace Setsudan
