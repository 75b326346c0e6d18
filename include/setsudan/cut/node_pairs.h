#pragma once

#include <deal.II/base/tensor.h>

#include <setsudan/cut/cut_surface.h>
#include <setsudan/elasticity/elastic_model.h>

#include <bitset>
#include <vector>

namespace Setsudan
{
/**
 * A node of the cut surface as its two sides have it. Before the surgery, and
 * at the tip of a cut that ends inside the body, both are the same node.
 */
template <int dim>
struct NodePair
{
  using NodeIndices = typename Discretization<dim>::NodeIndices;

  /** The node's number in the uncut body. */
  unsigned int number;
  dealii::Point<dim> position;
  /** Unit normal of the cut there, from minus to plus. */
  dealii::Tensor<1, dim> normal;
  /** Whether it is a corner of elements, and not the middle of an edge. */
  bool is_corner;
  NodeIndices minus;
  NodeIndices plus;
  /** Components that a support holds, on both sides. */
  std::bitset<dim> supported;

  /** Whether the two sides have a node each. */
  bool
  is_double() const;
};

/**
 * All node pairs of a cut surface, the same on every process, in the order of
 * their numbers. They are found face by face: a position alone may belong to
 * several nodes once the body has been cut before.
 */
template <int dim>
std::vector<NodePair<dim>>
collect_node_pairs(const ElasticModel<dim> &model,
                   const CutSurface<dim> &surface,
                   const Body<dim> &body);
} // namespace Setsudan
