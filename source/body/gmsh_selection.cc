#include <setsudan/body/gmsh_selection.h>

#include <gmsh.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace Setsudan
{
namespace
{
/** Types of elements as gmsh numbers them. */
struct Types
{
  std::vector<int> linear, quadratic;
  std::string description;
};

Types
types_of_dimension(const unsigned int dim)
{
  if (dim == 2)
    return {{3}, {16, 10}, "quadrilaterals of 4, 8 or 9 nodes"};
  return {{5}, {17, 12}, "hexahedra of 8, 20 or 27 nodes"};
}

bool
contains(const std::vector<int> &types, const int type)
{
  return std::find(types.begin(), types.end(), type) != types.end();
}

std::vector<int>
find_entities(const unsigned int dim, const GmshOutline &outline)
{
  gmsh::vectorpair entities, groups;
  gmsh::model::getEntities(entities, dim);
  gmsh::model::getPhysicalGroups(groups, dim);
  double saves_all;
  gmsh::option::getNumber("Mesh.SaveAll", saves_all);
  const bool only_groups =
    outline.is_geometry && !groups.empty() && saves_all == 0;

  std::vector<int> found;
  for (const auto &[dimension, entity] : entities)
    {
      std::vector<int> groups_of_entity;
      gmsh::model::getPhysicalGroupsForEntity(
        dimension, entity, groups_of_entity);
      if (!only_groups || !groups_of_entity.empty())
        found.push_back(entity);
    }
  return found;
}

struct Properties
{
  std::string name;
  unsigned int dimension;
};

Properties
properties_of_type(const int type)
{
  std::string name;
  int dimension, order, n_nodes, n_corners;
  std::vector<double> local_coordinates;
  gmsh::model::mesh::getElementProperties(
    type, name, dimension, order, n_nodes, local_coordinates, n_corners);
  return {name, static_cast<unsigned int>(dimension)};
}

/** The types of the elements in question. Where an entity has hexahedra of 8
 * and of 20 nodes, gmsh itself only tells the type of the first. */
std::set<int>
find_types(const unsigned int dim,
           const GmshOutline &outline,
           const std::vector<int> &entities)
{
  std::set<int> types;
  for (const int type : outline.element_types)
    if (properties_of_type(type).dimension == dim)
      types.insert(type);
  if (outline.is_geometry)
    for (const int entity : entities)
      {
        std::vector<int> of_entity;
        gmsh::model::mesh::getElementTypes(of_entity, dim, entity);
        types.insert(of_entity.begin(), of_entity.end());
      }
  return types;
}

/** The names of some types; those that `condition` holds for. */
template <typename Condition>
std::string
list_names(const std::set<int> &types, const Condition &condition)
{
  std::string names;
  for (const int type : types)
    if (condition(type))
      names += (names.empty() ? "" : ", ") + properties_of_type(type).name;
  return names;
}
} // namespace


GmshSelection
select_gmsh_elements(const unsigned int dim, const GmshOutline &outline)
{
  std::vector<int> larger;
  gmsh::model::mesh::getElementTypes(larger, 3);
  if (dim == 2 && !larger.empty())
    throw std::runtime_error("the body has 2 dimensions, but there are "
                             "elements " +
                             properties_of_type(larger.front()).name);
  const auto entities = find_entities(dim, outline);
  const auto types    = find_types(dim, outline, entities);
  if (types.empty())
    throw std::runtime_error("there are no elements of dimension " +
                             std::to_string(dim));
  const auto allowed    = types_of_dimension(dim);
  const auto is_foreign = [&](const int type) {
    return !contains(allowed.linear, type) &&
           !contains(allowed.quadratic, type);
  };
  const std::string foreign = list_names(types, is_foreign);
  if (!foreign.empty())
    throw std::runtime_error("there are elements of other kinds (" + foreign +
                             "); allowed are only " + allowed.description);
  if (types.size() > 1)
    throw std::runtime_error("there are mixed cells (" +
                             list_names(types, [](int) { return true; }) +
                             "); all must have the same number of nodes");
  const int type = *types.begin();
  return {type, contains(allowed.quadratic, type), entities};
}
} // namespace Setsudan
