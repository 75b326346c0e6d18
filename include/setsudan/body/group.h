// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <boost/serialization/array.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <setsudan/mesh/entity_key.h>

#include <string>
#include <vector>

namespace Setsudan
{
/** A part of a body that the scene can address: a physical group of a gmsh
 * file, or a face of a box. */
struct Group
{
  /** May be empty; then the group is addressed by its number only. */
  std::string name;
  /** gmsh's number of the physical group, unique among those of a dimension;
   * for the faces of a box from 1. */
  int number;
  /** 0 for points to dim for cells. */
  unsigned int dimension;
  /** The elements, where `dimension` is that of the body, ascending. */
  std::vector<unsigned int> cells;
  /** The faces, lines or vertices otherwise, in vertices of the uncut body. */
  std::vector<EntityKey> entities;

  template <class Archive>
  void
  serialize(Archive &archive, const unsigned int)
  {
    archive &name &number &dimension &cells &entities;
  }
};

/** The groups that have a word as their name, or as their number. */
std::vector<const Group *>
find_groups(const std::vector<Group> &groups, const std::string &word);

/** A group as messages name it: "ground" (2, faces), with its number, or
 * 2 (faces) where it has no name.
 *
 * @param dim the dimension of the body. */
std::string
describe_group(const Group &group, const unsigned int dim);

/** Groups as a list for messages. */
std::string
list_groups(const std::vector<const Group *> &groups, const unsigned int dim);
} // namespace Setsudan
