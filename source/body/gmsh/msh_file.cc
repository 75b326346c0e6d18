// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/gmsh_numbers.h>
#include <setsudan/body/gmsh/msh_file.h>
#include <setsudan/parameters/exceptions.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <sstream>
#include <tuple>

namespace Setsudan
{
namespace
{
/** Refuse repeated numbers, and 0, which gmsh does not count from. */
void
check_unique(std::vector<unsigned int> numbers, const std::string &what)
{
  std::sort(numbers.begin(), numbers.end());
  if (!numbers.empty() && numbers.front() == 0)
    throw BodyFileError("the file has " + what +
                        " 0, and gmsh counts from 1; number the " + what +
                        "s anew");
  const auto twice = std::adjacent_find(numbers.begin(), numbers.end());
  if (twice != numbers.end())
    throw BodyFileError("the file lists " + what + " " +
                        std::to_string(*twice) + " twice");
}

void
check_count(const GmshNumbers &numbers,
            const std::string &what,
            const std::size_t announced,
            const std::size_t found)
{
  if (found != announced)
    numbers.section.throw_damaged("announces " + std::to_string(announced) +
                                  " " + what + " and lists " +
                                  std::to_string(found));
}

/** Read the names of physical groups: their count, and for each dimension,
 * number, and name in quotes. */
void
read_physical_names(const GmshSection &section, GmshMesh &mesh)
{
  std::istringstream text{std::string(section.content)};
  std::size_t n_names = 0;
  bool is_list        = bool(text >> n_names);
  for (std::size_t i = 0; i < n_names && is_list; ++i)
    {
      unsigned int dimension = 0;
      int number             = 0;
      char quote             = ' ';
      std::string name;
      is_list = text >> dimension >> number >> quote && dimension <= 3 &&
                quote == '"' && std::getline(text, name, '"');
      for (const auto &[key, other] : mesh.group_names)
        if (is_list && key.first == dimension && other == name)
          throw BodyFileError(
            "two physical groups of dimension " + std::to_string(dimension) +
            " have the name '" + name + "', numbers " +
            std::to_string(key.second) + " and " + std::to_string(number) +
            ", of which gmsh keeps one; give each a name of "
            "its own");
      mesh.group_names.try_emplace({dimension, number}, name);
    }
  text >> std::ws;
  if (!is_list || !text.eof())
    section.throw_damaged("is no list of groups");
}

/** The physical groups of geometrical entities, by dimension and number of the
 * entity. */
using GroupsOfEntities =
  std::map<std::pair<unsigned int, int>, std::vector<int>>;

/** Read $Entities, or $PartitionedEntities, of version 4.1. The borders between
 * the parts of a partitioned mesh, made out of entities of a larger dimension,
 * are in no groups. */
void
read_entities(GmshNumbers numbers,
              const bool is_partitioned,
              GroupsOfEntities &groups)
{
  if (is_partitioned)
    {
      numbers.read_number(); // of parts
      // Entity and part of what the parts have beside their own.
      numbers.read_integers(2 * numbers.read_number());
    }
  std::array<std::size_t, 4> n_entities;
  for (std::size_t &n : n_entities)
    n = numbers.read_number();
  for (int dimension = 0; dimension <= 3; ++dimension)
    for (std::size_t i = 0; i < n_entities[dimension]; ++i)
      {
        auto &of_entity      = groups[{dimension, numbers.read_integer()}];
        int parent_dimension = dimension;
        if (is_partitioned)
          {
            parent_dimension = numbers.read_integer();
            numbers.read_integer();                       // the parent
            numbers.read_integers(numbers.read_number()); // the parts
          }
        numbers.skip_reals(dimension == 0 ? 3 : 6); // where it is
        const auto listed = numbers.read_integers(numbers.read_number());
        if (parent_dimension <= dimension)
          of_entity.insert(of_entity.end(), listed.begin(), listed.end());
        if (dimension > 0)
          numbers.read_integers(numbers.read_number()); // what bounds it
      }
  numbers.expect_end();
}

void
read_nodes_2(GmshNumbers &numbers, GmshMesh &mesh)
{
  const std::size_t n_nodes = numbers.read_count_2();
  for (std::size_t i = 0; i < n_nodes; ++i)
    {
      const unsigned int number = numbers.read_number();
      mesh.nodes.push_back({number, numbers.read_point()});
    }
}

/** Blocks: dimension and number of the entity, whether nodes have parameters on
 * it, number of nodes, the nodes' numbers, and their coordinates. */
void
read_nodes_4(GmshNumbers &numbers, GmshMesh &mesh)
{
  const std::size_t n_blocks = numbers.read_number();
  const std::size_t n_nodes  = numbers.read_number();
  const std::size_t smallest = numbers.read_number();
  const std::size_t largest  = numbers.read_number();
  for (std::size_t block = 0; block < n_blocks; ++block)
    {
      const auto entity            = numbers.read_integers(3);
      const std::size_t n_in_block = numbers.read_number();
      const std::size_t first      = mesh.nodes.size();
      if (entity[0] < 0 || entity[0] > 3)
        numbers.section.throw_damaged("names an entity of dimension " +
                                      std::to_string(entity[0]));
      for (std::size_t i = 0; i < n_in_block; ++i)
        {
          const unsigned int number = numbers.read_number();
          if (number < smallest || number > largest)
            numbers.section.throw_damaged(
              "has a node " + std::to_string(number) +
              ", but announces nodes from " + std::to_string(smallest) +
              " to " + std::to_string(largest));
          mesh.nodes.push_back({number, {}});
        }
      for (std::size_t i = first; i < mesh.nodes.size(); ++i)
        {
          mesh.nodes[i].position = numbers.read_point();
          numbers.skip_reals(entity[2] != 0 ? entity[0] : 0);
        }
    }
  check_count(numbers, "nodes", n_nodes, mesh.nodes.size());
}

void
read_nodes(GmshNumbers numbers, GmshMesh &mesh)
{
  if (numbers.format.is_version_4)
    read_nodes_4(numbers, mesh);
  else
    read_nodes_2(numbers, mesh);
  numbers.expect_end();
  std::vector<unsigned int> node_numbers;
  for (const auto &node : mesh.nodes)
    node_numbers.push_back(node.number);
  check_unique(std::move(node_numbers), "node");
  mesh.sort_nodes();
}

/** What an unknown type of elements can be too. */
const std::string wrong_counts =
  ", or the counts in the section $Elements are wrong";

/** Reads elements into the blocks of a mesh. */
class Elements
{
public:
  Elements(const GmshNumbers &numbers, GmshMesh &mesh)
    : numbers(numbers)
    , mesh(mesh)
  {
  }

  /** In text one by one: number, type, number of tags, tags, nodes. In binary
   * blocks: type, number of elements, number of tags, and for each element
   * number, tags, nodes. */
  void
  read_2()
  {
    const bool has_blocks        = numbers.format.is_binary;
    const std::size_t n_elements = numbers.read_count_2();
    while (element_numbers.size() < n_elements)
      {
        unsigned int element         = has_blocks ? 0 : numbers.read_number();
        const int type               = numbers.read_integer();
        const std::size_t n_in_block = has_blocks ? numbers.read_number() : 1;
        const std::size_t n_tags     = numbers.read_number();
        for (std::size_t i = 0; i < n_in_block; ++i)
          {
            element = has_blocks ? numbers.read_number() : element;
            // The first two are group and entity.
            auto tags = numbers.read_integers(n_tags);
            tags.resize(2);
            read_element(element,
                         type,
                         tags[1],
                         tags[0] == 0 ? std::vector<int>()
                                      : std::vector<int>{tags[0]});
          }
      }
    finish(n_elements);
  }

  /** Blocks: dimension and number of the entity, type, number of elements, and
   * for each element number, nodes.
   *
   * @param groups nothing where the file lists no entities. */
  void
  read_4(const GroupsOfEntities &groups)
  {
    const std::size_t n_blocks   = numbers.read_number();
    const std::size_t n_elements = numbers.read_number();
    numbers.read_number(); // the smallest number
    numbers.read_number(); // the largest number
    for (std::size_t block = 0; block < n_blocks; ++block)
      {
        numbers.read_integer(); // the dimension, which the type tells
        const int entity             = numbers.read_integer();
        const int type               = numbers.read_integer();
        const std::size_t n_in_block = numbers.read_number();
        const unsigned int dimension = gmsh_type(type, wrong_counts).dimension;
        const auto known             = groups.find({dimension, entity});
        if (known == groups.end() && !groups.empty())
          numbers.section.throw_damaged(
            "names the entity " + std::to_string(entity) + " of dimension " +
            std::to_string(dimension) + ", which $Entities does not list");
        const auto of_entity =
          known == groups.end() ? std::vector<int>() : known->second;
        for (std::size_t i = 0; i < n_in_block; ++i)
          read_element(numbers.read_number(), type, entity, of_entity);
      }
    finish(n_elements);
  }

private:
  void
  read_element(const unsigned int element,
               const int type,
               const int entity,
               const std::vector<int> &groups)
  {
    const unsigned int n_nodes  = gmsh_type(type, wrong_counts).n_nodes;
    const auto [number, is_new] = block_numbers.try_emplace(
      std::make_tuple(type, entity, groups), mesh.blocks.size());
    if (is_new)
      mesh.blocks.push_back({type, entity, groups, {}, {}});
    auto &block = mesh.blocks[number->second];
    element_numbers.push_back(element);
    block.numbers.push_back(element);
    for (unsigned int i = 0; i < n_nodes; ++i)
      {
        block.nodes.push_back(numbers.read_number());
        if (mesh.find_node(block.nodes.back()) == nullptr)
          throw BodyFileError(
            "element " + std::to_string(element) + " has the node " +
            std::to_string(block.nodes.back()) + ", which does not exist");
      }
  }

  void
  finish(const std::size_t n_elements)
  {
    check_count(numbers, "elements", n_elements, element_numbers.size());
    numbers.expect_end();
    check_unique(element_numbers, "element");
  }

  GmshNumbers numbers;
  GmshMesh &mesh;
  std::vector<unsigned int> element_numbers;
  std::map<std::tuple<int, int, std::vector<int>>, std::size_t> block_numbers;
};
} // namespace


GmshMesh
read_msh_file(const TextFile &file)
{
  const auto sections     = split_sections(file);
  const GmshFormat format = parse_format(sections.front());
  GmshMesh mesh;
  GroupsOfEntities groups;
  for (const auto &section : sections)
    if (section.name == "PhysicalNames")
      read_physical_names(section, mesh);
    else if (section.name == "Nodes")
      read_nodes({section, format}, mesh);
    else if (format.is_version_4 && (section.name == "Entities" ||
                                     section.name == "PartitionedEntities"))
      read_entities({section, format}, section.name != "Entities", groups);
  for (const auto &[entity, of_entity] : groups)
    for (const int group : of_entity)
      mesh.group_names.try_emplace({entity.first, std::abs(group)});
  for (const auto &section : sections)
    if (section.name == "Elements")
      {
        Elements elements({section, format}, mesh);
        format.is_version_4 ? elements.read_4(groups) : elements.read_2();
      }
  return mesh;
}
} // namespace Setsudan
