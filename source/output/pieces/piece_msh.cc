// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/gmsh_session.h>
#include <setsudan/mesh/node_order.h>
#include <setsudan/output/pieces/element_order.h>
#include <setsudan/output/pieces/piece_mesh.h>

#include <gmsh.h>

#include <map>
#include <numeric>

namespace Setsudan
{
namespace
{
/** gmsh's quadratic elements without face and centre nodes. */
int
element_type(const unsigned int dimension)
{
  constexpr int types[] = {15, 8, 16, 17};
  return types[dimension];
}

/** The nodes of an entity in gmsh's order, where ours is that of nodes.h. */
std::vector<unsigned int>
gmsh_order(const unsigned int dimension)
{
  switch (dimension)
    {
      case 0:
        return {0};
      case 1:
        return {0, 1, 2};
      case 2:
        return node_order<2>(gmsh_edges<2>());
      default:
        return node_order<3>(gmsh_edges<3>());
    }
}

/** An element in gmsh's sense, with its number. */
struct NumberedEntity
{
  std::size_t number;
  std::vector<unsigned int> nodes;
};

/** Entities of one dimension by the groups that they are in, since gmsh has
 * an element once only. */
using GroupedEntities =
  std::map<std::vector<unsigned int>, std::vector<NumberedEntity>>;

/** @param next the number of the next entity, which is not one of the piece's
 * elements: those keep theirs. */
template <int dim>
GroupedEntities
sort_by_groups(const PieceMesh<dim> &piece,
               const unsigned int dimension,
               std::size_t &next)
{
  std::map<std::vector<unsigned int>, std::vector<unsigned int>> groups_of;
  for (unsigned int g = 0; g < piece.groups.size(); ++g)
    if (piece.groups[g].dimension == dimension)
      for (const auto &entity : piece.groups[g].entities)
        groups_of[entity].push_back(g);

  GroupedEntities sorted;
  if (dimension == dim)
    for (const auto &element : piece.elements)
      {
        const std::vector<unsigned int> nodes(element.begin(), element.end());
        const auto groups = groups_of.find(nodes);
        sorted[groups == groups_of.end() ? std::vector<unsigned int>()
                                         : groups->second]
          .push_back({next++, nodes});
      }
  else
    for (const auto &[entity, groups] : groups_of)
      sorted[groups].push_back({next++, entity});
  return sorted;
}

/** Write the entities of one dimension, and the groups they form. */
template <int dim>
void
add_entities(const PieceMesh<dim> &piece,
             const unsigned int dimension,
             std::size_t &next)
{
  const auto order = gmsh_order(dimension);
  std::map<int, std::vector<int>> tags_of_group;
  int tag = 0, largest_group = 0;
  for (const auto &group : piece.groups)
    if (group.dimension == dimension)
      largest_group = std::max(largest_group, group.number);
  for (const auto &[groups, entities] : sort_by_groups(piece, dimension, next))
    {
      ++tag;
      if (dimension < dim || tag > 1)
        gmsh::model::addDiscreteEntity(dimension, tag);
      std::vector<std::size_t> nodes, numbers;
      for (const auto &entity : entities)
        {
          numbers.push_back(entity.number);
          for (const unsigned int node : order)
            nodes.push_back(entity.nodes[node] + 1);
        }
      gmsh::model::mesh::addElementsByType(
        tag, element_type(dimension), numbers, nodes);
      for (const unsigned int g : groups)
        tags_of_group[piece.groups[g].number].push_back(tag);
      if (groups.empty())
        tags_of_group[largest_group + 1].push_back(tag);
    }
  for (const auto &[number, tags] : tags_of_group)
    {
      gmsh::model::addPhysicalGroup(dimension, tags, number);
      std::string name = number > largest_group ? "piece" : "";
      for (const auto &group : piece.groups)
        if (group.dimension == dimension && group.number == number)
          name = group.name;
      if (!name.empty())
        gmsh::model::setPhysicalName(dimension, number, name);
    }
}
} // namespace


template <int dim>
void
write_piece_msh(const PieceMesh<dim> &piece,
                const OutputDirectory &directory,
                const std::string &name)
{
  std::vector<std::size_t> node_tags(piece.nodes.size());
  std::iota(node_tags.begin(), node_tags.end(), 1);

  const GmshSession session;
  gmsh::model::add("piece");
  gmsh::model::addDiscreteEntity(dim, 1);
  gmsh::model::mesh::addNodes(dim, 1, node_tags, coordinates<dim>(piece.nodes));
  std::size_t next = 1;
  for (int dimension = dim; dimension >= 0; --dimension)
    add_entities(piece, dimension, next);
  directory.write_file(
    name, [](const std::string &file_name) { gmsh::write(file_name); });
}



template void
write_piece_msh(const PieceMesh<2> &,
                const OutputDirectory &,
                const std::string &);
template void
write_piece_msh(const PieceMesh<3> &,
                const OutputDirectory &,
                const std::string &);
} // namespace Setsudan
