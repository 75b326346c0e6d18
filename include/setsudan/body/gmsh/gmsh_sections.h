// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/gmsh/gmsh_numbers.h>

#include <set>
#include <string>
#include <vector>

namespace Setsudan
{
// gmsh 4.8 trusts the counts and numbers in a mesh file: where they are wrong,
// it crashes, takes a node for another, or leaves out what is behind. These
// functions walk through a section as gmsh will, and throw std::runtime_error
// where it must not.

/**
 * Check a section $Nodes: it is complete, and its nodes' numbers are within
 * gmsh's range and, in version 4.1, within the one that it announces.
 *
 * @return the numbers, ascending.
 */
std::vector<unsigned int>
check_nodes_section(const std::string &version,
                    const GmshSection &section,
                    const bool is_binary);

/**
 * Check a section $Elements: it is complete, its elements are of first or
 * second order, and all numbers are within gmsh's range.
 *
 * @param nodes the numbers that elements may name, ascending.
 * @return gmsh's types of all elements.
 */
std::set<int>
check_elements_section(const std::string &version,
                       const GmshSection &section,
                       const bool is_binary,
                       const std::vector<unsigned int> &nodes);
} // namespace Setsudan
