// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/body.h>
#include <setsudan/mesh/cell_lines.h>
#include <setsudan/mesh/face_index.h>

#include <vector>

namespace Setsudan
{
/**
 * Check that the elements of a file make up a body that can be computed: no
 * middle node is outside of the middle half of its line, and no element flat or
 * turned inside out; a face belongs to one element, or to two on different
 * sides of it; elements that share a line share its middle node, and that is no
 * node of other lines, where the elements would come apart under load.
 *
 * @param vertex_numbers  the numbers of the vertices, ascending.
 * @param element_numbers the file's.
 * @throw BodyFileError that names elements and nodes by the file's numbers.
 */
template <int dim>
void
check_body(const Body<dim> &body,
           const FaceIndex<dim> &faces,
           const std::vector<CellLine> &lines,
           const std::vector<unsigned int> &vertex_numbers,
           const std::vector<unsigned int> &element_numbers);
} // namespace Setsudan
