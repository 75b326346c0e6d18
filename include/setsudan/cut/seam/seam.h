// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/seam/rows.h>
#include <setsudan/mechanics/pieces/piece_motions.h>

#include <set>
#include <vector>

namespace Setsudan
{
/** How the two nodes of a pair are held together. */
enum class PairState
{
  /** They move as one. */
  tied,
  /** The blade keeps them its thickness apart, along the normal. */
  opened,
  free
};

using PairStates = std::vector<PairState>;

/**
 * The two sides of a cut as a list of node pairs in rows. What holds the sides
 * together is a pure function of the states of the pairs. Before the surgery
 * all pairs are single nodes and there is nothing to hold.
 */
template <int dim>
class Seam
{
public:
  /** @throw CutError where more than two sides meet at a node. */
  Seam(const std::vector<NodePair<dim>> &pairs, const std::vector<Row> &rows);

  const std::vector<NodePair<dim>> &
  pairs() const;

  const std::vector<Row> &
  rows() const;

  /** The states when the first rows are split, each pair of them being in the
   * state `split`, and the others are tied. */
  PairStates
  states_after(const unsigned int n_split, const PairState split) const;

  /** Free a row besides. */
  PairStates
  released(PairStates states, const unsigned int row) const;

  /**
   * Leave out all pairs with a node in one of some pieces: they are free in all
   * states and no part of any front any more; a front may become empty.
   *
   * @param pieces the piece of every element behind the surgery.
   */
  void
  leave_out(const std::vector<unsigned int> &pieces,
            const std::set<unsigned int> &left_out);

  /**
   * The links that the pairs make between pieces: all components where they are
   * tied, the normal one where they are opened.
   */
  std::vector<PieceLink<dim>>
  links(const PairStates &states,
        const std::vector<unsigned int> &pieces) const;

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
   * Add the homogeneous constraints of the seam. A support takes precedence
   * over a tie and over an opening. Where one side is constrained already,
   * because a floating piece is held there, the other one is constrained to it.
   */
  void
  add_constraints(const PairStates &states,
                  dealii::AffineConstraints<double> &constraints) const;

  /**
   * A displacement that has the opening of the opened pairs,
   * n.(u+ - u-) = thickness, by as few unknowns as possible.
   */
  LA::Vector
  opening(const PairStates &states,
          const ElasticModel<dim> &model,
          const double thickness) const;

private:
  /** The side of a pair whose unknowns its constraints determine. A node may be
   * in several pairs, where an earlier cut ends at this one. */
  enum class Dependent
  {
    none,
    minus,
    plus
  };

  void
  choose_dependent_sides();

  const typename NodePair<dim>::NodeIndices &
  dependent(const unsigned int pair) const;

  const typename NodePair<dim>::NodeIndices &
  independent(const unsigned int pair) const;

  std::vector<NodePair<dim>> node_pairs;
  std::vector<Row> node_rows;
  /** Of pairs that have been left out. */
  std::vector<bool> is_left_out;
  std::vector<Dependent> dependent_sides;
};
} // namespace Setsudan
