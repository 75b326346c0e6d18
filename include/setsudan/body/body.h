// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <setsudan/body/box_numbering.h>
#include <setsudan/body/group.h>
#include <setsudan/mesh/coarse_mesh.h>

#include <array>
#include <optional>
#include <vector>

namespace Setsudan
{
/** The body before any cut: its elements, its node numbers, and the parts of
 * it that have names. */
template <int dim>
struct Body
{
  CoarseMesh<dim> mesh;

  /** The numbers of each element's nodes, in the order of nodes.h: the paper's
   * for a box, the file's for a file. */
  std::vector<std::array<unsigned int, n_element_nodes<dim>>> node_numbers;

  std::vector<Group> groups;

  /** The layers of elements, where the body is a box. */
  std::optional<BoxNumbering<dim>> box;

  /** Whether the nodes in the middle of lines are nodes of the model: they are
   * not, where elements are linear and not refined. */
  bool has_middle_nodes = true;

  /** How often the model has all elements halved along each axis. */
  unsigned int n_halvings = 0;
  /** Nodes of the file that belong to no element, ascending. */
  std::vector<unsigned int> unused_nodes;

  /** How many different nodes there are. */
  unsigned int
  n_nodes() const;

  bool
  has_node(const unsigned int number) const;

  /** The number of the node that a vertex is. */
  unsigned int
  node_of_vertex(const unsigned int vertex) const;
};

/** A box from the origin to `size`. Its groups are its faces: left and right
 * (x min and max), front and back (y), bottom and top (z; in 2D y). */
template <int dim>
Body<dim>
make_box(const dealii::Point<dim> &size,
         const typename BoxNumbering<dim>::Indices &n_elements);
} // namespace Setsudan
