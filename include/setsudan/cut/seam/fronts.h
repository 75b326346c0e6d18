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
  /** Those the blade rests on, along the edge. In a front that is closed the
   * first node stands at the end again. */
  std::vector<unsigned int> front;
  /** Where the edge positions of the front's nodes are, ascending. */
  std::vector<double> positions;
  /** The integral of each of these nodes' shape function along the lines of
   * the front: as much of an even load falls to it [length]. */
  std::vector<double> lengths;
  /** How far the front lies behind the entry, along the blade's direction; of
   * one that is not straight, how far the straight edge does that has opened
   * the same area. */
  double depth;
};

/** A part of a front: nodes that follow each other along the edge. */
struct Chain
{
  std::vector<unsigned int> nodes;
  bool closed;
};

/** Set the front of a row to chains of nodes, with their positions along the
 * edge.
 *
 * @param axis_follows whether these are the coordinates of an axis. */
template <int dim>
void
set_front(const SurfaceNodes<dim> &nodes,
          const BladeEdge<dim> &edge,
          const std::vector<Chain> &chains,
          const bool axis_follows,
          Row &row);

/** Set the fronts of rows, which hold all of their nodes, and positions along
 * the edge (see make_rows()). */
template <int dim>
void
order_fronts(const SurfaceNodes<dim> &nodes,
             const BladeEdge<dim> &edge,
             std::vector<Row> &rows);
} // namespace Setsudan
