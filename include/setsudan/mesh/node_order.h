// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

// How gmsh lists the nodes of a quadratic element: around the bottom, around
// the top, and then edge by edge. VTK does so too, with another order of edges.

namespace Setsudan
{
/** Pairs of corners, numbered as gmsh and VTK do. */
using Edges = std::vector<std::array<unsigned int, 2>>;

/** gmsh's order of the mid-side nodes. */
template <int dim>
Edges
gmsh_edges();

/** VTK's order of the mid-side nodes, and that of Abaqus and CalculiX. */
template <int dim>
Edges
vtk_edges();

/** For each node of an element whose mid-side nodes lie on `edges`, one behind
 * the other, its number in ours (see nodes.h). */
template <int dim>
std::vector<unsigned int>
node_order(const Edges &edges);
} // namespace Setsudan
