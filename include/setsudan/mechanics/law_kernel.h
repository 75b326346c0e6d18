// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/cell_batches.h>
#include <setsudan/mechanics/elastic_model.h>

#include <deal.II/lac/full_matrix.h>

#include <memory>
#include <vector>

namespace Setsudan
{
/** Whether the kernels know all that resists a displacement under finite
 * strain: neo-Hookean laws in the displacement formulation, on elements that
 * are not linear, without pressures that follow the surface. The functions
 * below are for such bodies, and many times faster than LawIntegration. */
template <int dim>
bool
has_law_kernel(const ElasticModel<dim> &model);

/** evaluate_laws() by the kernels. */
template <int dim>
InternalForces
evaluate_by_kernel(const ElasticModel<dim> &model,
                   const LA::Vector &displacement);

/** The tangent for products without a matrix. */
template <int dim>
std::shared_ptr<const typename CellBatches<dim>::Tangent>
tangent_by_kernel(const ElasticModel<dim> &model,
                  const Linearization &linearization);

/** The matrices of the cells, from a tangent of the kernels. */
template <int dim>
class TangentMatrices
{
public:
  using Tangent = typename CellBatches<dim>::Tangent;

  TangentMatrices(const ElasticModel<dim> &model,
                  std::shared_ptr<const Tangent> tangent);

  /** That of a cell by its number in the batches, in the order of the cell's
   * unknowns; until the next call. */
  const dealii::FullMatrix<double> &
  operator()(const unsigned int cell);

private:
  const CellBatches<dim> &batches;
  const std::shared_ptr<const Tangent> tangent;
  const dealii::AlignedVector<double> gradients;
  /** Where each of a cell's unknowns is in what the kernel makes. */
  std::vector<unsigned int> places;
  /** Of all cells of one batch. */
  dealii::AlignedVector<double> of_batch;
  unsigned int present_batch = dealii::numbers::invalid_unsigned_int;
  dealii::FullMatrix<double> matrix;
};
} // namespace Setsudan
