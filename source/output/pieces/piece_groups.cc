// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mesh/face_index.h>
#include <setsudan/output/pieces/piece_groups.h>

#include <algorithm>
#include <map>
#include <set>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The nodes of a cell's vertices, lines or faces. */
using LocalNodes = std::vector<std::vector<unsigned int>>;

/** The local nodes of all vertices (dimension 0), lines (1) or faces of a cell,
 * in the order of nodes.h. */
template <int dim>
LocalNodes
entities_of_cell(const unsigned int dimension)
{
  constexpr unsigned int n_corners = GeometryInfo<dim>::vertices_per_cell;
  LocalNodes entities;
  if (dimension == 0)
    for (unsigned int v = 0; v < n_corners; ++v)
      entities.push_back({v});
  else if (dimension == 1)
    for (unsigned int l = 0; l < GeometryInfo<dim>::lines_per_cell; ++l)
      entities.push_back({GeometryInfo<dim>::line_to_cell_vertices(l, 0),
                          GeometryInfo<dim>::line_to_cell_vertices(l, 1),
                          n_corners + l});
  else
    for (unsigned int f = 0; f < GeometryInfo<dim>::faces_per_cell; ++f)
      {
        entities.emplace_back();
        for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_face; ++v)
          entities.back().push_back(
            GeometryInfo<dim>::face_to_cell_vertices(f, v));
        for (unsigned int l = 0; l < GeometryInfo<dim>::lines_per_face; ++l)
          entities.back().push_back(
            n_corners + GeometryInfo<dim>::face_to_cell_lines(f, l));
      }
  return entities;
}



/** An entity of an element as the uncut body knows it. */
template <int dim>
EntityKey
key_in_body(const Body<dim> &body,
            const unsigned int element,
            const std::vector<unsigned int> &local_nodes)
{
  std::vector<unsigned int> vertices;
  for (const unsigned int node : local_nodes)
    if (node < GeometryInfo<dim>::vertices_per_cell)
      vertices.push_back(body.mesh.cells[element].vertices[node]);
  return make_entity_key(vertices);
}



/** The entities of a piece that a test on their keys in the body picks, each
 * once: its two sides are two, where a cut runs through it. */
template <int dim, typename Test>
std::vector<std::vector<unsigned int>>
pick_entities(const PieceMesh<dim> &piece,
              const Body<dim> &body,
              const unsigned int dimension,
              const Test &test)
{
  const auto local = entities_of_cell<dim>(dimension);
  std::set<std::vector<unsigned int>> seen;
  std::vector<std::vector<unsigned int>> entities;
  for (unsigned int e = 0; e < piece.elements.size(); ++e)
    for (const auto &nodes : local)
      if (test(key_in_body(body, piece.elements_in_body[e], nodes)))
        {
          std::vector<unsigned int> entity;
          for (const unsigned int node : nodes)
            entity.push_back(piece.elements[e][node]);
          auto sorted = entity;
          std::sort(sorted.begin(), sorted.end());
          if (seen.insert(sorted).second)
            entities.push_back(entity);
        }
  return entities;
}



template <int dim>
PieceGroup
restrict_group(const Group &group,
               const PieceMesh<dim> &piece,
               const Body<dim> &body)
{
  PieceGroup part{group.name, group.number, group.dimension, {}};
  if (group.dimension == dim)
    {
      for (unsigned int e = 0; e < piece.elements.size(); ++e)
        if (std::binary_search(group.cells.begin(),
                               group.cells.end(),
                               piece.elements_in_body[e]))
          part.entities.emplace_back(piece.elements[e].begin(),
                                     piece.elements[e].end());
      return part;
    }
  const std::set<EntityKey> keys(group.entities.begin(), group.entities.end());
  part.entities =
    pick_entities(piece, body, group.dimension, [&](const EntityKey &key) {
      return keys.count(key) > 0;
    });
  return part;
}
} // namespace


template <int dim>
std::set<CellFace>
find_opened_faces(const CoarseMesh<dim> &mesh, const Body<dim> &body)
{
  const auto before = collect_neighbors(body.mesh);
  const auto after  = collect_neighbors(mesh);
  std::set<CellFace> opened;
  for (unsigned int cell = 0; cell < before.size(); ++cell)
    for (unsigned int f = 0; f < GeometryInfo<dim>::faces_per_cell; ++f)
      if (before[cell][f] != after[cell][f])
        opened.insert({cell, f});
  return opened;
}



template <int dim>
std::vector<PieceGroup>
collect_piece_groups(const PieceMesh<dim> &piece,
                     const std::set<CellFace> &opened,
                     const Body<dim> &body)
{
  std::vector<PieceGroup> groups;
  for (const auto &group : body.groups)
    groups.push_back(restrict_group(group, piece, body));

  auto cut = std::find_if(groups.begin(), groups.end(), [](const auto &group) {
    return group.name == "cut" && group.dimension == dim - 1;
  });
  if (cut == groups.end())
    {
      int number = 1;
      for (const auto &group : groups)
        if (group.dimension == dim - 1)
          number = std::max(number, group.number + 1);
      groups.push_back({"cut", number, dim - 1, {}});
      cut = groups.end() - 1;
    }
  const auto faces = entities_of_cell<dim>(dim - 1);
  for (unsigned int e = 0; e < piece.elements.size(); ++e)
    for (unsigned int f = 0; f < faces.size(); ++f)
      if (opened.count({piece.elements_in_body[e], f}) > 0)
        {
          auto &face = cut->entities.emplace_back();
          for (const unsigned int node : faces[f])
            face.push_back(piece.elements[e][node]);
        }

  groups.erase(std::remove_if(groups.begin(),
                              groups.end(),
                              [](const PieceGroup &group) {
                                return group.entities.empty();
                              }),
               groups.end());
  return groups;
}



template std::vector<PieceGroup>
collect_piece_groups(const PieceMesh<2> &,
                     const std::set<CellFace> &,
                     const Body<2> &);
template std::set<CellFace>
find_opened_faces(const CoarseMesh<2> &, const Body<2> &);
template std::vector<PieceGroup>
collect_piece_groups(const PieceMesh<3> &,
                     const std::set<CellFace> &,
                     const Body<3> &);
template std::set<CellFace>
find_opened_faces(const CoarseMesh<3> &, const Body<3> &);
} // namespace Setsudan
