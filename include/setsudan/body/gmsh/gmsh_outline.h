// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

namespace Setsudan
{
/** What can be known of a gmsh file without gmsh. */
struct GmshOutline
{
  /** An entry of the mesh file's list of physical groups; gmsh forgets those
   * that have no elements. */
  struct GroupName
  {
    unsigned int dimension;
    int number;
    std::string name;
  };

  /** A geometry, which has yet to be meshed; everything below is for meshes. */
  bool is_geometry;
  /** "2.2" or "4.1". */
  std::string version;
  /** The numbers of all nodes, ascending. gmsh forgets those of no element, or
   * does not, as files differ. */
  std::vector<unsigned int> node_numbers;
  /** gmsh's types of all elements. */
  std::set<int> element_types;
  std::vector<GroupName> group_names;
};

/**
 * Look at a file before gmsh reads it: gmsh takes any text for a geometry,
 * and a mesh file that was cut off can give it part of a mesh.
 *
 * @throw std::runtime_error where the file does not exist, is neither .msh nor
 * .geo, or is a mesh of another version or without all of its sections.
 */
GmshOutline
outline_gmsh_file(const std::string &file_name);
} // namespace Setsudan
