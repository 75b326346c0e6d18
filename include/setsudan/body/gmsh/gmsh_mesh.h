// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Setsudan
{
/** A type of gmsh's elements. */
struct GmshType
{
  const char *name;
  unsigned int dimension, n_nodes, n_corners;
};

/** The type that has a number.
 *
 * @throw BodyFileError where it is not of first or second order; `or_else` says
 * what else can be wrong. */
const GmshType &
gmsh_type(const int number, const std::string &or_else = "");

/** A mesh as its file lists it, or as gmsh makes it of a geometry. */
struct GmshMesh
{
  struct Node
  {
    unsigned int number;
    dealii::Point<3> position;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &number &position;
    }
  };

  /** Elements of one type in one geometrical entity and the same groups. */
  struct Block
  {
    /** One that gmsh_type() knows. */
    int type;
    int entity;
    /** The numbers of the physical groups; negative where it turns round. */
    std::vector<int> groups;
    std::vector<unsigned int> numbers;
    /** Of one element behind the other, in gmsh's order. */
    std::vector<unsigned int> nodes;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &type &entity &groups &numbers &nodes;
    }
  };

  bool is_of_geometry = false;
  /** Ascending. */
  std::vector<Node> nodes;
  /** None of them is without elements. */
  std::vector<Block> blocks;
  /** The names of physical groups, which can be empty, by dimension and number:
   * all that have one, and all that entities name. */
  std::map<std::pair<unsigned int, int>, std::string> group_names;

  /** Make the nodes ascend. */
  void
  sort_nodes();

  /** The node of a number, or nothing. */
  const Node *
  find_node(const std::size_t number) const;

  template <class Archive>
  void
  serialize(Archive &archive, const unsigned int)
  {
    archive &is_of_geometry &nodes &blocks &group_names;
  }
};
} // namespace Setsudan
