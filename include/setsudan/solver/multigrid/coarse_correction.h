// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/solver/linear/algebraic_multigrid.h>
#include <setsudan/solver/multigrid/q1_coarse_space.h>

#include <memory>

namespace Setsudan
{
/**
 * The coarse correction of p-multigrid: one cycle of algebraic multigrid on the
 * stiffness of the trilinear space.
 *
 * It costs most of the preparation, and stays admissible when constraints are
 * removed: it serves several rows of a cut in turn.
 */
template <int dim>
class CoarseCorrection
{
public:
  using Vector = typename CellBatches<dim>::Vector;

  /** @param lines the constraints for the model's batches.
   * @param tangent in the place of the stiffness at rest; or null. */
  CoarseCorrection(const ElasticModel<dim> &model,
                   const dealii::AffineConstraints<double> &constraints,
                   const LocalConstraints &lines,
                   std::shared_ptr<const typename CellBatches<dim>::Tangent>
                     tangent = nullptr);

  /** Whether the displacements of this space obey other constraints: whether
   * one of them does that has no symmetry. */
  bool
  is_compatible_with(const LocalConstraints &others,
                     const CellBatches<dim> &batches) const;

  /** Add the displacement under forces to one that is constrained by `now`. */
  void
  add(Vector &displacement,
      const Vector &forces,
      const LocalConstraints &now) const;

private:
  const Q1CoarseSpace<dim> space;
  const std::unique_ptr<const Epetra_CrsMatrix> stiffness;
  AlgebraicMultigrid solver;
  mutable Vector coarse_forces, correction;
};
} // namespace Setsudan
