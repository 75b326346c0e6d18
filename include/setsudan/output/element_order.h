#pragma once

#include <setsudan/output/piece_mesh.h>

#include <array>
#include <vector>

// How gmsh and VTK list the nodes of a quadratic element, which both do around
// the bottom, around the top, and then edge by edge in orders of their own.

namespace Setsudan
{
/** Pairs of corners, numbered as the other programs do. */
using Edges = std::vector<std::array<unsigned int, 2>>;

/** VTK's order of the mid-side nodes. */
template <int dim>
Edges
vtk_edges();

/** gmsh's order of the mid-side nodes. */
template <int dim>
Edges
gmsh_edges();

/** The nodes' coordinates one behind the other, always three each. */
template <int dim>
std::vector<double>
coordinates(const PieceMesh<dim> &piece);

/** The elements' nodes one behind the other, in another program's order and
 * counted from `first_number`. */
template <int dim>
std::vector<std::size_t>
connectivity(const PieceMesh<dim> &piece,
             const Edges &edges,
             const std::size_t first_number);
} // namespace Setsudan
