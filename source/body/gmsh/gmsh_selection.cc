// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/point.h>

#include <setsudan/body/gmsh/gmsh_selection.h>

#include <gmsh.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

namespace Setsudan
{
namespace
{
/** Types of elements as gmsh numbers them. */
struct Types
{
  std::vector<int> linear, quadratic;
  std::string description, way_out;
};

Types
types_of_dimension(const unsigned int dim)
{
  if (dim == 2)
    return {{3},
            {16, 10},
            "quadrilaterals of 4, 8 or 9 nodes",
            "Recombine all surfaces, or set Mesh.SubdivisionAlgorithm = 1"};
  return {{5},
          {17, 12},
          "hexahedra of 8, 20 or 27 nodes",
          "Recombine all surfaces and extrusions, set "
          "Mesh.SubdivisionAlgorithm = 2, or lay blocks around an axis as in "
          "prm/bodies/cake_slice.geo"};
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

std::string
list_names(const std::set<int> &types)
{
  std::string names;
  for (const int type : types)
    names += (names.empty() ? "" : ", ") + properties_of_type(type).name;
  return names;
}

/** The numbers of all elements of a type in some entities. */
std::vector<std::size_t>
elements_of_type(const int type, const std::vector<int> &entities)
{
  std::vector<std::size_t> elements;
  for (const int entity : entities)
    {
      std::vector<std::size_t> numbers, nodes;
      gmsh::model::mesh::getElementsByType(type, numbers, nodes, entity);
      elements.insert(elements.end(), numbers.begin(), numbers.end());
    }
  return elements;
}

/** The mean of an element's nodes. */
dealii::Point<3>
center_of_element(const std::size_t element)
{
  int type;
  std::vector<std::size_t> nodes;
  gmsh::model::mesh::getElement(element, type, nodes);
  dealii::Point<3> center;
  for (const std::size_t node : nodes)
    {
      std::vector<double> position, parameters;
      gmsh::model::mesh::getNode(node, position, parameters);
      for (unsigned int d = 0; d < 3; ++d)
        center[d] += position[d] / nodes.size();
    }
  return center;
}

/** How many elements of each type there are, and where the first ones are. */
std::string
describe_elements(const std::vector<int> &types,
                  const std::vector<int> &entities)
{
  std::ostringstream description;
  description.precision(4);
  for (const int type : types)
    {
      const auto elements = elements_of_type(type, entities);
      description << (type == types.front() ? "" : ", ") << elements.size()
                  << " of " << properties_of_type(type).name;
      if (elements.empty())
        continue;
      const auto first  = *std::min_element(elements.begin(), elements.end());
      const auto center = center_of_element(first);
      description << ", the first of which is element " << first << " around ("
                  << center[0] << ", " << center[1] << ", " << center[2] << ")";
    }
  return description.str();
}

/** Refuse a mesh that has no elements of dimension `dim`. */
[[noreturn]] void
throw_no_elements(const unsigned int dim, const GmshOutline &outline)
{
  std::string smaller;
  for (int dimension = dim - 1; dimension >= 0; --dimension)
    {
      std::vector<int> types;
      gmsh::model::mesh::getElementTypes(types, dimension);
      if (!types.empty())
        smaller +=
          (smaller.empty() ? ", only " : ", ") + describe_elements(types, {-1});
    }
  const std::string part = dim == 3 ? "volume" : "surface";
  throw std::runtime_error(
    "there are no elements of dimension " + std::to_string(dim) + smaller +
    (outline.is_geometry
       ? "; the geometry needs a " + part + " that gmsh can mesh"
       : "; where there are physical groups, gmsh saves only their elements: "
         "give the geometry a Physical " +
           (dim == 3 ? std::string("Volume") : "Surface") +
           ", or set Mesh.SaveAll = 1"));
}

/** Refuse what a body cannot be made of. */
void
check_types(const unsigned int dim,
            const std::set<int> &types,
            const std::vector<int> &entities)
{
  const auto allowed = types_of_dimension(dim);
  std::vector<int> foreign;
  for (const int type : types)
    if (!contains(allowed.linear, type) && !contains(allowed.quadratic, type))
      foreign.push_back(type);
  if (!foreign.empty())
    throw std::runtime_error("there are elements of other kinds (" +
                             describe_elements(foreign, entities) +
                             "); allowed are only " + allowed.description +
                             ": " + allowed.way_out);
  if (types.size() > 1)
    throw std::runtime_error("there are mixed cells (" + list_names(types) +
                             "); all must have the same number of nodes");
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
    throw_no_elements(dim, outline);
  check_types(dim, types, entities);
  const int type = *types.begin();
  return {type, contains(types_of_dimension(dim).quadratic, type), entities};
}
} // namespace Setsudan
