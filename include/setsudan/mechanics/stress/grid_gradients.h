// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/cell_batches.h>
#include <setsudan/mechanics/elastic_model.h>

#include <functional>

namespace Setsudan
{
/**
 * Displacement gradients of a batch of cells: see
 * StiffnessKernel::serendipity_gradients.
 */
struct GradientsOfBatch
{
  CellBatch batch;
  /** The number of its first cell in CellBatches::cells(). */
  unsigned int first_cell;
  unsigned int n_lanes;
  /** At the grid of 3^dim points with the nodes in it, then at Gauss's points:
   * [point][component][direction][lane]. */
  const double *values;

  /** The gradient at a point in the cell of a lane. */
  template <int dim>
  dealii::Tensor<2, dim>
  at(const unsigned int point, const unsigned int lane) const
  {
    dealii::Tensor<2, dim> gradient;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        gradient[c][d] = values[((point * dim + c) * dim + d) * n_lanes + lane];
    return gradient;
  }
};

/**
 * Visit the displacement's gradients in all cells of this process, batch by
 * batch; for elements with nodes on their lines.
 *
 * @param displacement with ghosts up to date.
 */
template <int dim>
void
visit_gradients(const ElasticModel<dim> &model,
                const typename CellBatches<dim>::Vector &displacement,
                const std::function<void(const GradientsOfBatch &)> &visit);
} // namespace Setsudan
