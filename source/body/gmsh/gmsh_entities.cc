// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/gmsh_entities.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace Setsudan
{
using namespace dealii;

namespace
{
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
  throw std::runtime_error(message + ", which belongs to no element");
}
} // namespace


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
