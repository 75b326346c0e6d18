#pragma once

#include <setsudan/cut/blade_edge.h>
#include <setsudan/cut/node_pairs.h>

#include <vector>

namespace Setsudan
{
/** Nodes of a cut that the blade reaches together. */
struct Layer
{
  /** Indices of node pairs. */
  std::vector<unsigned int> nodes;
  /** The same along the edge; the first stands at the end again in a front
   * that is closed. */
  std::vector<unsigned int> front;
  /** Positions of the front's nodes along the edge, ascending. */
  std::vector<double> positions;
  /** How far the blade has travelled from its entry. */
  double depth;
};

/** Set the fronts of all layers and their positions along the edge (see
 * make_rows()). */
template <int dim>
void
order_fronts(const SurfaceNodes<dim> &nodes,
             const BladeEdge<dim> &edge,
             std::vector<Layer> &layers);
} // namespace Setsudan
