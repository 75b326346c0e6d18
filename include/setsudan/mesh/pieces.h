// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mesh/coarse_mesh.h>

#include <vector>

namespace Setsudan
{
/**
 * The separate bodies that a mesh consists of: for every cell the number of its
 * piece. Cells that share a face belong together.
 *
 * Numbers are stable: of the parts of an earlier piece the one with the
 * smallest cell keeps the number, the others get the next free ones in the
 * order of their smallest cells.
 *
 * @param earlier the pieces before, or empty: then they are counted from 0.
 */
template <int dim>
std::vector<unsigned int>
find_pieces(const CoarseMesh<dim> &mesh,
            const std::vector<unsigned int> &earlier = {});
} // namespace Setsudan
