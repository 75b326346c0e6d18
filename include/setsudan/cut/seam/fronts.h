// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/blade/blade_edge.h>
#include <setsudan/cut/seam/node_pairs.h>

#include <vector>

namespace Setsudan
{
/** Nodes of the cut that are split together. */
struct Row
{
  /** All of them, as indices into the list of node pairs. */
  std::vector<unsigned int> pairs;
  /** Those the blade rests on: the first layer, along the edge. In a front
   * that is closed the first node stands at the end again. */
  std::vector<unsigned int> front;
  /** Where the edge positions of the front's nodes are, ascending. */
  std::vector<double> positions;
  /** How far the front lies behind the entry, along the blade's direction. */
  double depth;
};

/** Set the fronts of rows, which hold all of their nodes, and positions along
 * the edge (see make_rows()). */
template <int dim>
void
order_fronts(const SurfaceNodes<dim> &nodes,
             const BladeEdge<dim> &edge,
             std::vector<Row> &rows);
} // namespace Setsudan
