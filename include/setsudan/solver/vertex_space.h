#pragma once

#include <setsudan/elasticity/cell_batches.h>
#include <setsudan/elasticity/elastic_model.h>
#include <setsudan/solver/constraint_lines.h>
#include <setsudan/solver/node_blocks.h>

#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace Setsudan
{
/**
 * The displacements that are linear between vertices in each direction of a
 * cell, as a subspace of those of a body under constraints: with them multigrid
 * corrects what its smoother leaves.
 *
 * An unknown in the middle of a line, a face or a cell is the mean of those at
 * the vertices around it, and constrained ones are what the constraints make of
 * the others: by that rule alone ties, supports and hanging nodes are all
 * obeyed exactly, whichever they are. Every vertex has `dim` unknowns here, but
 * those that are constrained mean nothing.
 */
template <int dim>
class VertexSpace
{
public:
  using Constraints = dealii::AffineConstraints<double>;
  using Vector      = typename CellBatches<dim>::Vector;
  using Index       = dealii::types::global_dof_index;

  /** @param constraints homogeneous and closed.
   * @param lines        the same for the model's batches. */
  VertexSpace(ElasticModel<dim> &model,
              const Constraints &constraints,
              const ConstraintLines &lines);

  /** How vectors of this space are distributed. */
  const std::shared_ptr<const dealii::Utilities::MPI::Partitioner> &
  partitioner() const;

  /** Add a displacement of this space to one of the body; constrained unknowns
   * are left as they are. */
  void
  prolongate_and_add(Vector &fine, Vector &coarse) const;

  /** The transpose, for forces. */
  void
  restrict_forces(Vector &coarse, const Vector &fine) const;

  /** The stiffness of this space: exactly that of the body for its
   * displacements. */
  NodeBlocks<dim>
  stiffness() const;

  /** For each rigid motion its value in this process's unknowns. */
  std::vector<std::vector<double>>
  rigid_modes() const;

private:
  /** An unknown of the body by those of this space, and factors. */
  using Row = std::vector<std::pair<Index, double>>;

  /** Learn which nodes this process's and neighboring cells have. */
  void
  find_nodes();

  /** Give the vertices their numbers in this space. */
  void
  number_vertices();

  /** Ask their owners for unknowns that a constraint names and none of this
   * process's cells has. */
  void
  ask_for_rows();

  void
  make_transfer();

  Row
  row_of(const unsigned int place) const;

  /** The place of a node's component of one of the cells known here. */
  unsigned int
  place(const unsigned int cell,
        const unsigned int node,
        const unsigned int component) const;

  /** Whether some of a cell's unknowns are constrained. */
  bool
  is_constrained(const unsigned int cell) const;

  /** @param of_batch the stiffness that the vertices of this cell have in its
   * batch if nothing is constrained. */
  void
  add_cell(const unsigned int cell,
           const unsigned int lane,
           const dealii::AlignedVector<double> &of_batch,
           NodeBlocks<dim> &blocks) const;

  /** Whether all nodes of a cell, in spite of constraints, are where its
   * vertices take them. */
  bool
  are_linear(const std::vector<Row> &rows) const;

  template <typename Entry>
  void
  add_product(const std::vector<Row> &rows,
              const Entry &entry,
              NodeBlocks<dim> &blocks) const;

  ElasticModel<dim> &model;
  const CellBatches<dim> &batches;
  const Constraints &constraints;
  const ConstraintLines &lines;
  /** Vertices whose mean each node of a cell is. */
  std::vector<std::vector<unsigned int>> vertices_of_node;
  /** Where the nodes' first components are, cell by cell: those of the batches,
   * then those of neighboring processes' cells. */
  std::vector<unsigned int> node_places;
  /** A node of a cell that each place belongs to. */
  struct Site
  {
    unsigned int cell;
    unsigned char node, component;
  };
  std::vector<Site> sites;
  /** This space's unknown of each place at a vertex. */
  Vector numbers;
  Index first_number, n_owned_numbers;
  std::unordered_map<unsigned int, Row> rows_of_others;

  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> coarse_partitioner;
  /** The transfer, row by row of this process's unknowns. */
  std::vector<unsigned int> starts, columns;
  std::vector<double> weights;
};
} // namespace Setsudan
