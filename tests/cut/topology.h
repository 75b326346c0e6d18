// SPDX-License-Identifier: LGPL-2.1-or-later
// What a piece consists of, counted by the vertices that its cells name.
#pragma once

#include <setsudan/mesh/coarse_mesh.h>
#include <setsudan/mesh/face_index.h>
#include <setsudan/mesh/geometry.h>
#include <setsudan/mesh/pieces.h>

#include <algorithm>
#include <iostream>
#include <set>
#include <vector>

namespace Setsudan
{
struct Topology
{
  unsigned int n_cells    = 0;
  unsigned int n_vertices = 0;
  /** Vertices and lines: each of these has one. */
  unsigned int n_nodes = 0;
  /** Vertices - lines + faces (- cells in 3D): 1 for a ball, 0 for a ring, 2
   * for a ball with a bubble in it. */
  int euler_characteristic = 0;
  double volume            = 0;

  bool
  operator==(const Topology &other) const
  {
    return n_cells == other.n_cells && n_vertices == other.n_vertices &&
           n_nodes == other.n_nodes &&
           euler_characteristic == other.euler_characteristic;
  }
};


/** The topology of some cells of a mesh. */
template <int dim>
Topology
topology_of(const CoarseMesh<dim> &mesh, const std::vector<unsigned int> &cells)
{
  using Geometry = dealii::GeometryInfo<dim>;
  std::set<unsigned int> vertices;
  std::set<EntityKey> lines, faces;
  Topology topology;
  for (const unsigned int cell : cells)
    {
      const auto &corners = mesh.cells[cell].vertices;
      vertices.insert(corners.begin(), corners.end());
      for (unsigned int node = Geometry::vertices_per_cell;
           node < n_element_nodes<dim>;
           ++node)
        {
          const auto ends = vertices_of_node<dim>(node);
          lines.insert(make_entity_key(
            std::vector<unsigned int>{corners[ends[0]], corners[ends[1]]}));
        }
      for (unsigned int face = 0; face < Geometry::faces_per_cell; ++face)
        faces.insert(mesh.face_key({cell, face}));
      topology.volume += volume_of_element(mesh.node_positions(cell));
    }
  topology.n_cells    = cells.size();
  topology.n_vertices = vertices.size();
  topology.n_nodes    = vertices.size() + lines.size();
  const int n_cells   = cells.size();
  topology.euler_characteristic =
    dim == 3
      ? int(vertices.size()) - int(lines.size()) + int(faces.size()) - n_cells
      : int(vertices.size()) - int(lines.size()) + n_cells;
  return topology;
}


/** The topology of all pieces, in the order of their numbers. */
template <int dim>
std::vector<Topology>
topology_of_pieces(const CoarseMesh<dim> &mesh,
                   const std::vector<unsigned int> &pieces)
{
  std::vector<std::vector<unsigned int>> cells(
    *std::max_element(pieces.begin(), pieces.end()) + 1);
  for (unsigned int cell = 0; cell < pieces.size(); ++cell)
    cells[pieces[cell]].push_back(cell);
  std::vector<Topology> topologies;
  for (const auto &of_piece : cells)
    topologies.push_back(topology_of(mesh, of_piece));
  return topologies;
}


template <int dim>
unsigned int
n_boundary_faces(const CoarseMesh<dim> &mesh)
{
  unsigned int n = 0;
  for (const auto &of_cell : collect_neighbors(mesh))
    n += std::count(
      of_cell.begin(), of_cell.end(), dealii::numbers::invalid_unsigned_int);
  return n;
}


inline std::ostream &
operator<<(std::ostream &out, const Topology &topology)
{
  return out << topology.n_cells << " cells, " << topology.n_vertices
             << " vertices, " << topology.n_nodes << " nodes, characteristic "
             << topology.euler_characteristic << ", volume " << topology.volume;
}
} // namespace Setsudan
