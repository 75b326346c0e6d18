// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <setsudan/body/gmsh/gmsh_outline.h>
#include <setsudan/body/group.h>
#include <setsudan/mesh/nodes.h>

#include <array>
#include <string>
#include <vector>

namespace Setsudan
{
/** A mesh as gmsh hands it out: in the numbers of the file. */
template <int dim>
struct GmshMesh
{
  /** The numbers of an element's nodes, in the order of nodes.h. */
  using NodeNumbers = std::array<unsigned int, n_element_nodes<dim>>;

  /** The nodes, ascending, and where they are. */
  std::vector<unsigned int> node_numbers;
  std::vector<dealii::Point<3>> node_positions;

  /** Whether elements have middle nodes. Without, the numbers of middle nodes
   * are `invalid_unsigned_int`. */
  bool is_quadratic;

  /** Ascending. */
  std::vector<std::size_t> element_numbers;
  std::vector<NodeNumbers> elements;

  /** As in the body, but entities name numbers of nodes. */
  std::vector<Group> groups;

  template <class Archive>
  void
  serialize(Archive &archive, const unsigned int)
  {
    archive &node_numbers &node_positions &is_quadratic &element_numbers
      &elements &groups;
  }

  /** Where a node is. */
  const dealii::Point<3> &
  position(const unsigned int node_number) const;
};

/**
 * Let gmsh read a mesh, or mesh a geometry. A geometry is a program; so a child
 * process does it, which can neither run commands nor write files.
 *
 * @param time_limit in seconds.
 * @throw std::runtime_error where gmsh refuses the file, crashes or does not
 * end, elements are not of one kind that can be used, or numbers are too large.
 */
template <int dim>
GmshMesh<dim>
load_gmsh_mesh(const std::string &file_name,
               const GmshOutline &outline,
               const double time_limit);
} // namespace Setsudan
