// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/precondition.h>

#include <setsudan/solver/multigrid/coarse_correction.h>
#include <setsudan/solver/multigrid/constrained_stiffness.h>

#include <memory>

namespace Setsudan
{
/**
 * One cycle of multigrid over the order of the functions: Chebyshev's iteration
 * with the diagonal smooths, displacements that are linear between vertices
 * correct the rest, by one cycle of algebraic multigrid on their stiffness.
 *
 * The smoother: Adams, Brezina, Hu and Tuminaro 2003, Journal of Computational
 * Physics 188, 593-610.
 */
template <int dim>
class PMultigrid
{
public:
  using Vector = typename CellBatches<dim>::Vector;

  /** @param stiffness must live as long.
   * @param coarse    one that obeys the constraints of the stiffness. */
  PMultigrid(const ConstrainedStiffness<dim> &stiffness,
             std::shared_ptr<const CoarseCorrection<dim>> coarse);

  void
  vmult(Vector &result, const Vector &forces) const;

private:
  using Smoother =
    dealii::PreconditionChebyshev<ConstrainedStiffness<dim>, Vector>;

  const ConstrainedStiffness<dim> &stiffness;
  const std::shared_ptr<const CoarseCorrection<dim>> coarse;
  Smoother smoother;
  mutable Vector rest;
};
} // namespace Setsudan
