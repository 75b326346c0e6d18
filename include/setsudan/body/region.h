// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/body.h>

#include <set>
#include <vector>

namespace Setsudan
{
/**
 * A part of a body that can be asked whether a node belongs to it: groups with
 * all that bounds them, a box in space, or single nodes.
 *
 * Nodes are asked for by cell and point of the reference cell, in the uncut
 * body: so all copies of a node that was split belong to the same regions, and
 * nodes of refined cells do.
 */
template <int dim>
class Region
{
public:
  /** The groups, with the faces, lines and vertices of what is in them. */
  Region(const Body<dim> &body, const std::vector<const Group *> &groups);

  /** All points of the body in a box. */
  Region(const dealii::Point<dim> &lower, const dealii::Point<dim> &upper);

  /** Nodes by their numbers. */
  explicit Region(const std::set<unsigned int> &node_numbers);

  bool
  contains(const Body<dim> &body,
           const unsigned int cell,
           const dealii::Point<dim> &unit_point) const;

private:
  void
  add_with_boundary(const EntityKey &entity);

  std::vector<bool> cells;
  std::vector<EntityKey> entities;
  bool has_box = false;
  dealii::Point<dim> lower, upper;
  std::set<unsigned int> nodes;
};
} // namespace Setsudan
