// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mesh/node_order.h>
#include <setsudan/output/pieces/piece_mesh.h>

#include <vector>

// How meshes are handed to gmsh and VTK.

namespace Setsudan
{
/** The components of vectors one behind the other, always three each. */
template <int dim>
std::vector<double>
coordinates(const std::vector<dealii::Point<dim>> &vectors);

/** The elements' nodes one behind the other, in another program's order and
 * counted from `first_number`. */
template <int dim>
std::vector<std::size_t>
connectivity(const PieceMesh<dim> &piece,
             const Edges &edges,
             const std::size_t first_number);
} // namespace Setsudan
