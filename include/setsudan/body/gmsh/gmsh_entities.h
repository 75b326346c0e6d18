// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/group.h>
#include <setsudan/mesh/cell_lines.h>
#include <setsudan/mesh/face_index.h>

#include <vector>

namespace Setsudan
{
/**
 * Make groups name vertices instead of nodes.
 *
 * @param vertex_numbers the nodes that are vertices, ascending.
 * @throw std::runtime_error where a face, line or vertex of a group is none of
 * the elements'.
 */
template <int dim>
void
address_vertices(const FaceIndex<dim> &faces,
                 const std::vector<CellLine> &lines,
                 const std::vector<unsigned int> &vertex_numbers,
                 std::vector<Group> &groups);
} // namespace Setsudan
