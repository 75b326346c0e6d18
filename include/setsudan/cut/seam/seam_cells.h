// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/seam/seam.h>
#include <setsudan/mechanics/stress/stress_evaluator.h>

#include <utility>
#include <vector>

namespace Setsudan
{
/** The cells of this process that meet the nodes of a seam. */
template <int dim>
class SeamCells
{
public:
  using Cell = typename Discretization<dim>::Cell;

  /** A cell, some of its nodes, and the pair of each. */
  struct AdjacentCell
  {
    Cell cell;
    std::vector<unsigned int> nodes;
    std::vector<unsigned int> pairs;
  };

  /** @param model must live as long. */
  SeamCells(const ElasticModel<dim> &model, const Seam<dim> &seam);

  /** The cells that meet the front of a row, in the order of the mesh. */
  std::vector<AdjacentCell>
  at_front(const Row &row) const;

  /** Evaluates stress at the nodes of a cell, to which it is set. */
  StressEvaluator<dim> &
  at_nodes() const
  {
    return evaluator;
  }

private:
  /** Made once, since its tables of functions are the same for all rows. */
  mutable StressEvaluator<dim> evaluator;
  std::vector<Cell> cells;
  /** For each pair the cells, by their places in the list, and their nodes. */
  std::vector<std::vector<std::pair<unsigned int, unsigned int>>> of_pairs;
};
} // namespace Setsudan
