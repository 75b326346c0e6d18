// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/cell_batches.h>
#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/solver/multigrid/block_matrix_assembler.h>
#include <setsudan/solver/multigrid/q1_interpolation.h>

#include <functional>
#include <memory>
#include <vector>

namespace Setsudan
{
/**
 * The displacements that are linear between vertices in each direction of a
 * cell, as a subspace of those of a body under constraints: with them multigrid
 * corrects what its smoother leaves.
 *
 * By the rule of Q1Interpolation alone ties, supports and hanging nodes are all
 * obeyed exactly, whichever they are.
 */
template <int dim>
class Q1CoarseSpace
{
public:
  using Constraints = dealii::AffineConstraints<double>;
  using Vector      = typename CellBatches<dim>::Vector;
  using Index       = dealii::types::global_dof_index;

  /** @param constraints homogeneous and closed.
   * @param lines        the same for the model's batches. Both are needed as
   * long as more than transfers are asked for. */
  Q1CoarseSpace(const ElasticModel<dim> &model,
                const Constraints &constraints,
                const LocalConstraints &lines);

  /** How vectors of this space are distributed. */
  const std::shared_ptr<const dealii::Utilities::MPI::Partitioner> &
  partitioner() const;

  /** Add a displacement of this space to one of the body.
   *
   * @param now constraints whose unknowns are left as they are; or nothing. */
  void
  prolongate_and_add(Vector &fine,
                     Vector &coarse,
                     const LocalConstraints *now) const;

  /** The transpose, for forces. */
  void
  restrict_forces(Vector &coarse, const Vector &fine) const;

  /** The stiffness of this space: exactly that of the body for its
   * displacements.
   *
   * @param tangent in the place of that at rest; or null. */
  BlockMatrixAssembler<dim>
  stiffness(std::shared_ptr<const typename CellBatches<dim>::Tangent> tangent =
              nullptr) const;

  /** For each rigid motion its value in this process's unknowns. */
  std::vector<std::vector<double>>
  rigid_modes() const;

private:
  using Row = typename Q1Interpolation<dim>::Row;

  void
  make_transfer();

  using MatrixOfCell =
    std::function<const dealii::FullMatrix<double> &(unsigned int cell)>;

  /** @param of_batch the stiffness that the vertices of this cell have in its
   * batch if nothing is constrained.
   * @param matrix_of that of all unknowns of a cell. */
  void
  add_cell(const unsigned int cell,
           const unsigned int lane,
           const dealii::AlignedVector<double> &of_batch,
           const MatrixOfCell &matrix_of,
           BlockMatrixAssembler<dim> &blocks) const;

  /** Whether all nodes of a cell, in spite of constraints, are where its
   * vertices take them. */
  bool
  are_linear(const std::vector<Row> &rows_of_cell) const;

  template <typename Entry>
  void
  add_product(const std::vector<Row> &rows_of_cell,
              const Entry &entry,
              BlockMatrixAssembler<dim> &blocks) const;

  const ElasticModel<dim> &model;
  const CellBatches<dim> &batches;
  const Q1Interpolation<dim> rows;
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> coarse_partitioner;
  /** The transfer, row by row of this process's unknowns. */
  std::vector<unsigned int> starts, columns;
  std::vector<double> weights;
};
} // namespace Setsudan
