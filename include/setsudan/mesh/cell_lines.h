// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mesh/coarse_mesh.h>

#include <array>
#include <vector>

namespace Setsudan
{
/** A line of a cell. */
struct CellLine
{
  /** Its two vertices, the smaller first. */
  std::array<unsigned int, 2> vertices;
  unsigned int cell;
  /** The number of the line's middle node in the cell, see nodes.h. */
  unsigned int node;
};

/** All lines of all cells: those of the same vertices one behind the other, in
 * the order of cells, then nodes. */
template <int dim>
std::vector<CellLine>
collect_lines(const CoarseMesh<dim> &mesh);
} // namespace Setsudan
