// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/types.h>

#include <Epetra_CrsMatrix.h>

#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace Setsudan
{
/** A sparse matrix of dim x dim blocks, one for each pair of neighboring nodes,
 * as it is assembled. */
template <int dim>
class BlockMatrixAssembler
{
public:
  using Index = dealii::types::global_dof_index;

  /** @param first   the first node of this process.
   * @param n_owned how many it has. */
  BlockMatrixAssembler(const Index first,
                       const Index n_owned,
                       const MPI_Comm communicator);

  /** Where a block is kept, all 0 if it is new; until the next call. By rows.
   */
  double *
  block(const Index row, const Index column);

  /** Hand the rows of other processes to them, and give those unknowns whose
   * diagonal is 0 the mean one. */
  void
  finish();

  /** The matrix in Trilinos' format, unknowns node by node. */
  std::unique_ptr<Epetra_CrsMatrix>
  matrix() const;

private:
  struct RowOfNode
  {
    std::vector<Index> columns;
    std::vector<double> values;
  };

  bool
  owns(const Index node) const;

  RowOfNode &
  row_of(const Index node);

  void
  fill_diagonal();

  /** Nodes of other processes that this one's rows name, ascending. */
  std::vector<Index>
  columns_of_others() const;

  const Index first;
  const MPI_Comm communicator;
  std::vector<RowOfNode> rows;
  std::unordered_map<Index, RowOfNode> rows_of_others;
};
} // namespace Setsudan
