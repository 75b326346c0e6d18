// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/subscriptor.h>

#include <setsudan/mechanics/cell_batches.h>
#include <setsudan/solver/multigrid/local_constraints.h>

#include <memory>

namespace Setsudan
{
/** The stiffness of a body under homogeneous constraints, as an operator: the
 * condensed matrix C^T K C, and the identity on what is constrained. */
template <int dim>
class ConstrainedStiffness : public dealii::Subscriptor
{
public:
  using Vector  = typename CellBatches<dim>::Vector;
  using Tangent = typename CellBatches<dim>::Tangent;

  /** Both must live as long, and the batches must keep their partitioner.
   *
   * @param tangent in the place of the stiffness at rest; or null. */
  ConstrainedStiffness(const Discretization<dim> &discretization,
                       const CellBatches<dim> &batches,
                       const LocalConstraints &lines,
                       std::shared_ptr<const Tangent> tangent = nullptr);

  void
  vmult(Vector &result, const Vector &vector) const;

  /** Sizes, as deal.II's solvers ask for them. */
  dealii::types::global_dof_index
  m() const;

  /** Not known entry by entry: deal.II's smoother would ask for this if it were
   * not given the diagonal. */
  double
  el(const dealii::types::global_dof_index,
     const dealii::types::global_dof_index) const;

  /** The diagonal; at hanging nodes without what one cell's constrained
   * unknowns are to each other. */
  void
  diagonal(Vector &result) const;

  const CellBatches<dim> &batches;
  const LocalConstraints &lines;
  const std::shared_ptr<const Tangent> tangent;

private:
  const Discretization<dim> &discretization;
  /** What is worked with, all unknowns and ghosts. */
  mutable Vector displacement, forces;
};
} // namespace Setsudan
