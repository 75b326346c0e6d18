// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/gmsh/gmsh_mesh.h>
#include <setsudan/body/group.h>
#include <setsudan/mesh/cell_lines.h>
#include <setsudan/mesh/face_index.h>
#include <setsudan/mesh/nodes.h>

#include <array>
#include <vector>

namespace Setsudan
{
/** What a body takes of a mesh, in the numbers of the mesh. */
template <int dim>
struct GmshElements
{
  using Nodes = std::array<unsigned int, n_element_nodes<dim>>;

  /** Whether they have middle nodes. Without, the numbers of middle nodes are
   * `invalid_unsigned_int`. */
  bool is_quadratic;
  /** Ascending. */
  std::vector<unsigned int> numbers;
  /** The numbers of their nodes, in the order of nodes.h. */
  std::vector<Nodes> nodes;
  /** The physical groups by dimension and number. Cells are elements by their
   * place here, and entities name numbers of nodes. */
  std::vector<Group> groups;
};

/**
 * Take all elements of dimension `dim`. What version 2.2 lists once for each of
 * its groups is one element, of the smallest number.
 *
 * @throw BodyFileError where there are none, or not all are of one kind that
 * can be used.
 */
template <int dim>
GmshElements<dim>
take_elements(const GmshMesh &mesh);

/**
 * Make groups name vertices instead of nodes.
 *
 * @param vertex_numbers the nodes that are vertices, ascending.
 * @throw BodyFileError where a face, line or vertex of a group is none of the
 * elements'.
 */
template <int dim>
void
address_vertices(const FaceIndex<dim> &faces,
                 const std::vector<CellLine> &lines,
                 const std::vector<unsigned int> &vertex_numbers,
                 std::vector<Group> &groups);
} // namespace Setsudan
