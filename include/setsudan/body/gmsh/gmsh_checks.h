// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/body.h>
#include <setsudan/mesh/cell_lines.h>
#include <setsudan/mesh/face_index.h>

#include <vector>

namespace Setsudan
{
// Whether the elements of a file make up a body that can be computed. All
// functions throw std::runtime_error with a sentence that names elements and
// nodes by the numbers of the file.

/** No middle node is outside of the middle half of its line, and no element is
 * flat or turned inside out. */
template <int dim>
void
check_shapes(const Body<dim> &body,
             const std::vector<std::size_t> &element_numbers);

/** A face belongs to one element, or to two on different sides of it. */
template <int dim>
void
check_faces(const Body<dim> &body,
            const FaceIndex<dim> &faces,
            const std::vector<std::size_t> &element_numbers);

/** Elements that share a line share its middle node, and that is no node of
 * other lines: otherwise the elements would come apart there under load.
 *
 * @param vertex_numbers the numbers of the vertices, ascending. */
template <int dim>
void
check_lines(const Body<dim> &body,
            const std::vector<CellLine> &lines,
            const std::vector<unsigned int> &vertex_numbers,
            const std::vector<std::size_t> &element_numbers);

} // namespace Setsudan
