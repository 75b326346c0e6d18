// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/gmsh_groups.h>

#include <gmsh.h>

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace Setsudan
{
namespace
{
std::size_t
n_groups(const unsigned int dimension, const int entity)
{
  std::vector<int> numbers;
  gmsh::model::getPhysicalGroupsForEntity(dimension, entity, numbers);
  return numbers.size();
}

/** The elements of an entity, by their corners. */
std::vector<EntityKey>
list_elements(const unsigned int dimension, const int entity)
{
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> numbers, nodes;
  gmsh::model::mesh::getElements(types, numbers, nodes, dimension, entity);
  std::vector<EntityKey> keys;
  for (unsigned int i = 0; i < types.size(); ++i)
    {
      std::string name;
      int type_dimension, order, n_nodes, n_corners;
      std::vector<double> local_coordinates;
      gmsh::model::mesh::getElementProperties(types[i],
                                              name,
                                              type_dimension,
                                              order,
                                              n_nodes,
                                              local_coordinates,
                                              n_corners);
      if (n_corners > 4)
        throw std::runtime_error("there are elements " + name +
                                 ", which no group can hold");
      for (std::size_t first = 0; first < nodes[i].size(); first += n_nodes)
        keys.push_back(make_entity_key(std::vector<std::size_t>(
          nodes[i].begin() + first, nodes[i].begin() + first + n_corners)));
    }
  return keys;
}

/** Whether an entity is one that gmsh makes on the border between the parts of
 * a partitioned mesh, out of entities of a larger dimension. */
bool
is_border_of_partition(const unsigned int dimension, const int entity)
{
  int parent_dimension, parent;
  gmsh::model::getParent(dimension, entity, parent_dimension, parent);
  return parent_dimension > int(dimension);
}

/** The entities of a physical group of the file: gmsh adds groups of its own to
 * partitioned meshes. */
std::vector<int>
list_entities(const unsigned int dimension, const int number)
{
  std::vector<int> entities;
  gmsh::model::getEntitiesForPhysicalGroup(dimension, number, entities);
  entities.erase(std::remove_if(entities.begin(),
                                entities.end(),
                                [&](const int entity) {
                                  return is_border_of_partition(dimension,
                                                                entity);
                                }),
                 entities.end());
  return entities;
}

void
add_entity(const GmshOutline &outline, const int entity, Group &group)
{
  auto keys                  = list_elements(group.dimension, entity);
  const std::size_t n_listed = keys.size();
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  if (can_have_repetitions(outline, group.dimension, entity))
    check_repetitions(group.dimension, entity, n_listed, keys.size());
  group.entities.insert(group.entities.end(), keys.begin(), keys.end());
}

template <typename T>
void
sort_unique(std::vector<T> &values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

Group
load_group(const unsigned int dim,
           const GmshOutline &outline,
           const CellsOfEntities &cells,
           const unsigned int dimension,
           const int number)
{
  Group group = {"", number, dimension, {}, {}};
  gmsh::model::getPhysicalName(dimension, number, group.name);
  for (const int entity : list_entities(dimension, number))
    if (dimension < dim)
      add_entity(outline, entity, group);
    else if (const auto found = cells.find(entity); found != cells.end())
      group.cells.insert(
        group.cells.end(), found->second.begin(), found->second.end());
  sort_unique(group.cells);
  sort_unique(group.entities);
  return group;
}
} // namespace


bool
can_have_repetitions(const GmshOutline &outline,
                     const unsigned int dimension,
                     const int entity)
{
  return outline.version == "2.2" && n_groups(dimension, entity) > 1;
}



void
check_repetitions(const unsigned int dimension,
                  const int entity,
                  const std::size_t n_listed,
                  const std::size_t n_distinct)
{
  if (n_listed != n_distinct * n_groups(dimension, entity))
    throw std::runtime_error(
      "elements of dimension " + std::to_string(dimension) +
      " within the geometrical entity " + std::to_string(entity) +
      " are in different physical groups, which gmsh cannot tell apart in "
      "files of version 2.2; each group needs entities of its own");
}



std::vector<Group>
load_gmsh_groups(const unsigned int dim,
                 const GmshOutline &outline,
                 const CellsOfEntities &cells)
{
  std::vector<Group> groups;
  gmsh::vectorpair known;
  gmsh::model::getPhysicalGroups(known);
  for (const auto &[dimension, number] : known)
    if (dimension <= int(dim) && !list_entities(dimension, number).empty())
      groups.push_back(load_group(dim, outline, cells, dimension, number));
  for (const auto &[dimension, number, name] : outline.group_names)
    if (dimension <= dim &&
        std::find(known.begin(),
                  known.end(),
                  std::pair<int, int>(dimension, number)) == known.end())
      groups.push_back({name, number, dimension, {}, {}});
  std::sort(groups.begin(), groups.end(), [](const Group &a, const Group &b) {
    return std::tie(a.dimension, a.number) < std::tie(b.dimension, b.number);
  });
  return groups;
}
} // namespace Setsudan
