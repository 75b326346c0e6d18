// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/internal_variables.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Setsudan
{
/** Integrates the forces, the tangent and the energy of one cell after another
 * with whatever laws, by FEValues. Laws that are all linear have faster ways
 * (see CellBatches and ElementStiffness). */
template <int dim>
class LawIntegration
{
public:
  using Cell = typename Discretization<dim>::Cell;

  /** All must live as long. The trial state of the internal variables is set by
   * reinit(). */
  LawIntegration(const Discretization<dim> &discretization,
                 const MaterialParameters<dim> &materials,
                 InternalVariables<dim> &internal);

  /** Evaluate the laws in a cell.
   *
   * @param displacement  with ghosts.
   * @param needs_tangent whether `tangent` is set. */
  void
  reinit(const Cell &cell,
         const LA::Vector &displacement,
         const bool needs_tangent);

  // Of the present cell, in the order of its unknowns.
  dealii::Vector<double> forces;
  dealii::FullMatrix<double> tangent;
  double energy = 0;

private:
  /** Add what a point gives to the forces, or to the tangent. */
  void
  add_forces(const unsigned int point, const dealii::Tensor<2, 3> &stress);
  void
  add_tangent(const unsigned int point, const dealii::Tensor<4, 3> &of_law);

  const Discretization<dim> &discretization;
  const MaterialParameters<dim> &materials;
  InternalVariables<dim> &internal;
  dealii::FEValues<dim> fe_values;
  std::vector<dealii::Tensor<2, dim>> gradients;
};
} // namespace Setsudan
