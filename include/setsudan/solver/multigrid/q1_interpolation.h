// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/cell_batches.h>
#include <setsudan/solver/multigrid/local_constraints.h>

#include <unordered_map>
#include <utility>
#include <vector>

namespace Setsudan
{
/**
 * Interpolation of all unknowns from the multilinear ones at vertices, with
 * constraints applied: the value in the middle of a line, a face or a cell is
 * the mean of those at the vertices around it, and constrained values follow
 * from the constraints. Coarse numbering is local to this class, `dim` numbers
 * for each vertex; entries of constrained unknowns have no meaning.
 */
template <int dim>
class Q1Interpolation
{
public:
  using Constraints = dealii::AffineConstraints<double>;
  using Vector      = typename CellBatches<dim>::Vector;
  using Index       = dealii::types::global_dof_index;

  /** An unknown of the body by those at vertices, and factors. */
  using Row = std::vector<std::pair<Index, double>>;

  /** @param constraints homogeneous and closed; must live as long, as all.
   * @param lines        the same for the batches. */
  Q1Interpolation(const Discretization<dim> &discretization,
                  const CellBatches<dim> &batches,
                  const Constraints &constraints,
                  const LocalConstraints &lines);

  /** The unknown at a place of vectors of the batches. */
  Row
  row_of(const unsigned int place) const;

  /** Sum up terms of the same unknown. */
  static void
  unite(Row &row);

  /** The place of a node's component of one of the batches' cells. */
  unsigned int
  place(const unsigned int cell,
        const unsigned int node,
        const unsigned int component) const;

  /** Whether some of a cell's unknowns are constrained. */
  bool
  is_constrained(const unsigned int cell) const;

  bool
  is_at_vertex(const unsigned int place) const;

  /** The number of a place at a vertex. */
  Index
  number(const unsigned int place) const;

  /** The numbers of this process, which are contiguous, among all. */
  dealii::IndexSet
  owned_numbers() const;

  /** Vertices whose mean each node of a cell is. */
  const std::vector<std::vector<unsigned int>> vertices_of_node;

private:
  /** Learn which nodes this process's and neighboring cells have. */
  void
  find_nodes();

  void
  number_vertices();

  /** Ask their owners for unknowns that a constraint names and none of this
   * process's cells has. */
  void
  ask_for_rows();

  const Discretization<dim> &discretization;
  const CellBatches<dim> &batches;
  const Constraints &constraints;
  const LocalConstraints &lines;
  /** Where the nodes' first components are, cell by cell: those of the batches,
   * then those of neighboring processes' cells. */
  std::vector<unsigned int> node_places;
  /** A node of a cell that each place belongs to. */
  struct DofLocation
  {
    unsigned int cell;
    unsigned char node, component;
  };
  std::vector<DofLocation> dof_locations;
  Vector numbers;
  Index first_number, n_owned_numbers;
  std::unordered_map<unsigned int, Row> rows_of_others;
};
} // namespace Setsudan
