#pragma once

#include <setsudan/cut/seam/rows.h>
#include <setsudan/mechanics/pieces/piece_motions.h>

#include <set>
#include <vector>

namespace Setsudan
{
/**
 * What holds the two sides of a cut together: a list of node pairs in rows,
 * each pair tied (the sides move as one), opened (the blade keeps them its
 * thickness apart, along the normal) or free. Before the surgery all pairs are
 * single nodes and there is nothing to hold.
 */
template <int dim>
class Seam
{
public:
  enum class State
  {
    tied,
    opened,
    free
  };

  /** A seam of which all pairs are tied. */
  Seam(const std::vector<NodePair<dim>> &pairs, const std::vector<Row> &rows);

  const std::vector<NodePair<dim>> &
  pairs() const;

  const std::vector<Row> &
  rows() const;

  State
  state(const unsigned int pair) const;

  /** Whether any pair is not free. */
  bool
  holds() const;

  /** Pairs that are free stay so. */
  void
  set_row_state(const unsigned int row, const State state);

  void
  set_all_states(const State state);

  /**
   * Let go of all pairs with a node in one of some pieces, which are left out:
   * they are no part of any front any more, and a front may become empty.
   *
   * @param pieces the piece of every element behind the surgery.
   */
  void
  leave_out(const std::vector<unsigned int> &pieces,
            const std::set<unsigned int> &left_out);

  /** What the pairs let no two pieces do against each other: move at all where
   * they are tied, along the normal where they are opened. */
  std::vector<PieceLink<dim>>
  links(const std::vector<unsigned int> &pieces) const;

  /** Number of pairs with a node on each side. */
  unsigned int
  n_double_pairs() const;

  /**
   * The unknowns that constraints of the seam couple, on all processes: they
   * must be among the local lines of the constraints.
   */
  dealii::IndexSet
  coupled_indices(const dealii::types::global_dof_index n_unknowns) const;

  /**
   * Add the homogeneous part of what the seam demands. A support wins over a
   * tie and over an opening. Where one side is constrained already, because a
   * loose piece is held there, the other one follows it.
   */
  void
  add_constraints(dealii::AffineConstraints<double> &constraints) const;

  /**
   * A displacement that has the opening of the opened pairs,
   * n.(u+ - u-) = thickness, by as few unknowns as possible.
   */
  LA::Vector
  opening(const ElasticModel<dim> &model, const double thickness) const;

private:
  /** The side of a pair whose unknowns its constraints determine. A node may be
   * in several pairs, where an earlier cut ends at this one. */
  enum class Dependent
  {
    none,
    minus,
    plus
  };

  /** @throw std::runtime_error where two sides are not enough. */
  void
  choose_dependent_sides();

  /** The component that an opening determines: that of the largest normal. */
  unsigned int
  normal_component(const unsigned int pair) const;

  const typename NodePair<dim>::NodeIndices &
  dependent(const unsigned int pair) const;

  const typename NodePair<dim>::NodeIndices &
  independent(const unsigned int pair) const;

  std::vector<NodePair<dim>> node_pairs;
  std::vector<Row> node_rows;
  std::vector<State> states;
  std::vector<Dependent> dependent_sides;
};
} // namespace Setsudan
