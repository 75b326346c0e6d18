// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/support_parameters.h>

#include <bitset>
#include <optional>
#include <vector>

namespace Setsudan
{
/** A point of which some displacement components are held. */
template <int dim>
struct HeldPoint
{
  dealii::Point<dim> position;
  std::bitset<dim> components;
};

/** What the supports demand of a node. */
template <int dim>
struct NodeSupport
{
  std::bitset<dim> components;
  dealii::Tensor<1, dim> displacement;
};

/**
 * Which displacement components of which nodes are held. It is asked by cell
 * and point of the cell, so that the copies of a node that was split stay
 * held, and the nodes of refined cells are.
 */
template <int dim>
class Supports
{
public:
  /** @param body must live as long. */
  Supports(const SupportParameters<dim> &parameters, const Body<dim> &body);

  NodeSupport<dim>
  at(const unsigned int cell, const dealii::Point<dim> &unit_point) const;

  /** What is held of the nodes of some cells; a node may appear twice. */
  std::vector<HeldPoint<dim>>
  held_points(const std::vector<unsigned int> &cells) const;

  /** One by one, as the scene has them. */
  const std::vector<Support<dim>> &
  all() const;

  /** Whether a support moves what it holds. */
  bool
  move() const;

  /** A node whose supports contradict each other, if there is one. */
  std::optional<dealii::Point<dim>>
  find_contradiction() const;

  /** Whether pieces that no support holds are left out, and not held. */
  bool
  drop_loose_pieces() const;

private:
  const typename SupportParameters<dim>::LoosePieces floating_pieces;
  const std::vector<Support<dim>> supports;
  const Body<dim> &body;
};
} // namespace Setsudan
