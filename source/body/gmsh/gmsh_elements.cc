// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/gmsh_elements.h>
#include <setsudan/mesh/node_order.h>
#include <setsudan/parameters/exceptions.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** gmsh's types of the elements of one dimension. */
std::set<int>
find_types(const GmshMesh &mesh, const unsigned int dimension)
{
  std::set<int> types;
  for (const auto &block : mesh.blocks)
    if (gmsh_type(block.type).dimension == dimension)
      types.insert(block.type);
  return types;
}

/** The mean of an element's nodes. */
Point<3>
center_of_element(const GmshMesh &mesh,
                  const GmshMesh::Block &block,
                  const std::size_t element)
{
  const unsigned int n_nodes = gmsh_type(block.type).n_nodes;
  Point<3> center;
  for (unsigned int i = 0; i < n_nodes; ++i)
    center +=
      mesh.find_node(block.nodes[element * n_nodes + i])->position / n_nodes;
  return center;
}

/** How many elements of each type there are, and where the first ones are. */
std::string
describe_elements(const GmshMesh &mesh, const std::set<int> &types)
{
  std::ostringstream description;
  description.precision(4);
  for (const int type : types)
    {
      std::size_t n_elements = 0;
      unsigned int first     = std::numeric_limits<unsigned int>::max();
      Point<3> center;
      for (const auto &block : mesh.blocks)
        if (block.type == type)
          {
            n_elements += block.numbers.size();
            const auto smallest =
              std::min_element(block.numbers.begin(), block.numbers.end());
            if (*smallest < first)
              center = center_of_element(
                mesh, block, smallest - block.numbers.begin());
            first = std::min(first, *smallest);
          }
      description << (type == *types.begin() ? "" : ", ") << n_elements
                  << " of " << gmsh_type(type).name
                  << ", the first of which is element " << first << " around ("
                  << center[0] << ", " << center[1] << ", " << center[2] << ")";
    }
  return description.str();
}

/** Refuse a mesh that has no elements of dimension `dim`. */
[[noreturn]] void
throw_no_elements(const unsigned int dim, const GmshMesh &mesh)
{
  std::string smaller;
  for (int dimension = dim - 1; dimension >= 0; --dimension)
    if (const auto types = find_types(mesh, dimension); !types.empty())
      smaller +=
        (smaller.empty() ? ", only " : ", ") + describe_elements(mesh, types);
  const std::string part = dim == 3 ? "volume" : "surface";
  throw BodyFileError(
    "there are no elements of dimension " + std::to_string(dim) + smaller +
    (mesh.is_of_geometry
       ? "; the geometry needs a " + part + " that gmsh can mesh"
       : "; where there are physical groups, gmsh saves only their elements: "
         "give the geometry a Physical " +
           (dim == 3 ? std::string("Volume") : "Surface") +
           ", or set Mesh.SaveAll = 1"));
}

/** Refuse elements of other types than `allowed`. */
void
check_kinds(const unsigned int dim,
            const GmshMesh &mesh,
            std::set<int> types,
            const std::set<int> &allowed)
{
  for (const int type : allowed)
    types.erase(type);
  if (!types.empty())
    throw BodyFileError(
      "there are elements of other kinds (" + describe_elements(mesh, types) +
      "); allowed are only " +
      (dim == 2 ? "quadrilaterals of 4, 8 or 9 nodes: Recombine all surfaces, "
                  "or set Mesh.SubdivisionAlgorithm = 1"
                : "hexahedra of 8, 20 or 27 nodes: Recombine all surfaces and "
                  "extrusions, set Mesh.SubdivisionAlgorithm = 2, or lay "
                  "blocks around an axis as in prm/bodies/cake_slice.geo"));
}

/** The type of all elements of dimension `dim`, by gmsh's number. */
int
find_type(const unsigned int dim, const GmshMesh &mesh)
{
  if (const auto solids = find_types(mesh, 3); dim == 2 && !solids.empty())
    throw BodyFileError(std::string("the body has 2 dimensions, but there are "
                                    "elements ") +
                        gmsh_type(*solids.begin()).name);
  const auto types = find_types(mesh, dim);
  if (types.empty())
    throw_no_elements(dim, mesh);
  check_kinds(dim,
              mesh,
              types,
              dim == 2 ? std::set<int>{3, 10, 16} : std::set<int>{5, 12, 17});
  std::string names;
  for (const int type : types)
    names += (names.empty() ? "" : ", ") + std::string(gmsh_type(type).name);
  if (types.size() > 1)
    throw BodyFileError("there are mixed cells (" + names +
                        "); all must have the same number of nodes");
  return *types.begin();
}

/** An element of the body, and the block that lists it. */
template <int dim>
struct ListedElement
{
  unsigned int number;
  const GmshMesh::Block *block;
  typename GmshElements<dim>::Nodes nodes;
};

/** All elements of a type, by their numbers. */
template <int dim>
std::vector<ListedElement<dim>>
list_elements(const GmshMesh &mesh, const int type)
{
  const auto order           = node_order<dim>(gmsh_edges<dim>());
  const unsigned int n_nodes = gmsh_type(type).n_nodes;
  std::vector<ListedElement<dim>> elements;
  for (const auto &block : mesh.blocks)
    for (std::size_t i = 0; block.type == type && i < block.numbers.size(); ++i)
      {
        elements.push_back({block.numbers[i], &block, {}});
        auto &nodes = elements.back().nodes;
        nodes.fill(numbers::invalid_unsigned_int);
        // Nodes in the middle of faces and elements come last.
        for (unsigned int n = 0; n < n_nodes && n < order.size(); ++n)
          nodes[order[n]] = block.nodes[i * n_nodes + n];
      }
  // The file may list them in any order.
  std::sort(elements.begin(), elements.end(), [](const auto &a, const auto &b) {
    return a.number < b.number;
  });
  return elements;
}

/** Groups by dimension and number. */
using Groups = std::map<std::pair<unsigned int, int>, Group>;

/** The groups of a mesh, without the cells. */
Groups
collect_groups(const unsigned int dim, const GmshMesh &mesh)
{
  Groups groups;
  for (const auto &[key, name] : mesh.group_names)
    if (key.first <= dim)
      groups[key].name = name;
  for (const auto &block : mesh.blocks)
    for (const int number : block.groups)
      {
        const auto &type = gmsh_type(block.type);
        auto &entities   = groups[{type.dimension, std::abs(number)}].entities;
        for (auto nodes = block.nodes.begin();
             type.dimension < dim && nodes != block.nodes.end();
             nodes += type.n_nodes)
          entities.push_back(make_entity_key(
            std::vector<unsigned int>(nodes, nodes + type.n_corners)));
      }
  return groups;
}

template <typename T>
void
sort_unique(std::vector<T> &values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/** The vertices of an entity that is given by nodes; all are
 * `invalid_unsigned_int` where one is no vertex. */
EntityKey
vertices_of_entity(const EntityKey &nodes,
                   const std::vector<unsigned int> &vertex_numbers)
{
  EntityKey vertices = nodes;
  for (unsigned int i = 0; i < n_vertices(nodes); ++i)
    {
      const auto found = std::lower_bound(
        vertex_numbers.begin(), vertex_numbers.end(), nodes[i]);
      if (found == vertex_numbers.end() || *found != nodes[i])
        return make_entity_key(std::array<unsigned int, 0>());
      vertices[i] = found - vertex_numbers.begin();
    }
  return vertices;
}

template <int dim>
bool
is_in_mesh(const FaceIndex<dim> &faces,
           const std::vector<CellLine> &lines,
           const unsigned int dimension,
           const EntityKey &vertices)
{
  if (dimension == 0)
    return n_vertices(vertices) == 1;
  if (dimension + 1 == dim)
    return !faces.find(vertices).empty();
  const std::array<unsigned int, 2> ends = {{vertices[0], vertices[1]}};
  const auto found =
    std::lower_bound(lines.begin(),
                     lines.end(),
                     ends,
                     [](const CellLine &line, const auto &ends) {
                       return line.vertices < ends;
                     });
  return found != lines.end() && found->vertices == ends;
}

[[noreturn]] void
throw_foreign(const Group &group, const EntityKey &nodes)
{
  std::string message = "the physical group " + std::to_string(group.number);
  if (!group.name.empty())
    message += " '" + group.name + "'";
  message += " of dimension " + std::to_string(group.dimension) +
             " has something with the corners";
  for (unsigned int i = 0; i < n_vertices(nodes); ++i)
    message += " " + std::to_string(nodes[i]);
  throw BodyFileError(message + ", which belongs to no element");
}
} // namespace


template <int dim>
GmshElements<dim>
take_elements(const GmshMesh &mesh)
{
  const int type  = find_type(dim, mesh);
  Groups groups   = collect_groups(dim, mesh);
  const auto list = list_elements<dim>(mesh, type);
  GmshElements<dim> taken;
  taken.is_quadratic =
    gmsh_type(type).n_nodes > GeometryInfo<dim>::vertices_per_cell;
  // Which they are, and the blocks that list them first.
  std::map<typename GmshElements<dim>::Nodes,
           std::pair<unsigned int, const GmshMesh::Block *>>
    known;
  for (const auto &[number, block, nodes] : list)
    {
      const auto [first, is_new] =
        known.try_emplace(nodes, taken.numbers.size(), block);
      auto [cell, of_first] = first->second;
      if (is_new || of_first->entity != block->entity ||
          of_first->groups == block->groups)
        {
          cell = taken.numbers.size();
          taken.numbers.push_back(number);
          taken.nodes.push_back(nodes);
        }
      for (const int group : block->groups)
        groups[{dim, std::abs(group)}].cells.push_back(cell);
    }
  for (auto &[key, group] : groups)
    {
      std::tie(group.dimension, group.number) = key;
      sort_unique(group.cells);
      sort_unique(group.entities);
      taken.groups.push_back(std::move(group));
    }
  return taken;
}



template <int dim>
void
address_vertices(const FaceIndex<dim> &faces,
                 const std::vector<CellLine> &lines,
                 const std::vector<unsigned int> &vertex_numbers,
                 std::vector<Group> &groups)
{
  for (auto &group : groups)
    for (auto &entity : group.entities)
      {
        const auto vertices = vertices_of_entity(entity, vertex_numbers);
        if (!is_in_mesh(faces, lines, group.dimension, vertices))
          throw_foreign(group, entity);
        entity = vertices;
      }
}



template GmshElements<2>
take_elements(const GmshMesh &);
template GmshElements<3>
take_elements(const GmshMesh &);
template void
address_vertices(const FaceIndex<2> &,
                 const std::vector<CellLine> &,
                 const std::vector<unsigned int> &,
                 std::vector<Group> &);
template void
address_vertices(const FaceIndex<3> &,
                 const std::vector<CellLine> &,
                 const std::vector<unsigned int> &,
                 std::vector<Group> &);
} // namespace Setsudan
