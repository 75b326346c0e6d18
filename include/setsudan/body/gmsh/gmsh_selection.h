// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/gmsh/gmsh_outline.h>

#include <vector>

namespace Setsudan
{
/** Which of the elements that gmsh has are those of the body. */
struct GmshSelection
{
  /** gmsh's number for the type of all of them. */
  int type;
  bool has_middle_nodes;
  /** The geometrical entities that have them. */
  std::vector<int> entities;
};

/**
 * All elements of dimension `dim` of a mesh; of a geometry whose physical
 * groups have elements only these, as in the files that gmsh writes of it.
 *
 * @throw std::runtime_error where there are none, or not all are of one kind
 * that can be used.
 */
GmshSelection
select_gmsh_elements(const unsigned int dim, const GmshOutline &outline);
} // namespace Setsudan
