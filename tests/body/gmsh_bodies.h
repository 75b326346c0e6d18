// SPDX-License-Identifier: LGPL-2.1-or-later
// What the tests of gmsh files print of the bodies.
#pragma once

#include <setsudan/body/gmsh/gmsh_file.h>
#include <setsudan/mesh/geometry.h>

#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "../parameters/check.h"

namespace Setsudan
{
using namespace dealii;

template <int dim>
double
volume_of_body(const Body<dim> &body)
{
  double volume = 0;
  for (unsigned int cell = 0; cell < body.mesh.cells.size(); ++cell)
    volume += volume_of_element<dim>(body.mesh.node_positions(cell));
  return volume;
}


/** Nodes have one place from all elements, vertices one node, lines one
 * direction; and deal.II makes a triangulation of them. */
template <int dim>
void
check_body(const Body<dim> &body)
{
  std::map<unsigned int, Point<dim>> positions;
  std::map<unsigned int, unsigned int> nodes_of_vertices;
  std::set<std::pair<unsigned int, unsigned int>> lines;
  unsigned int n_wrong = 0;
  for (unsigned int cell = 0; cell < body.mesh.cells.size(); ++cell)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      {
        const unsigned int number = body.node_numbers[cell][node];
        const auto position       = body.mesh.node_position(cell, node);
        const auto &known         = positions.emplace(number, position);
        n_wrong += known.first->second.distance(position) > 1e-14;
        const auto ends      = vertices_of_node<dim>(node);
        const auto &vertices = body.mesh.cells[cell].vertices;
        if (ends[0] == ends[1])
          n_wrong +=
            nodes_of_vertices.emplace(vertices[node], number).first->second !=
            number;
        else
          {
            lines.emplace(vertices[ends[0]], vertices[ends[1]]);
            n_wrong += lines.count({vertices[ends[1]], vertices[ends[0]]});
          }
      }
  n_wrong += nodes_of_vertices.size() != body.mesh.vertices.size();
  Triangulation<dim> triangulation;
  create_triangulation(body.mesh, triangulation);
  check("nodes, vertices and lines agree", n_wrong == 0);
}


template <int dim>
void
print_size(const std::string &name, const Body<dim> &body)
{
  std::cout << name << ": " << body.mesh.cells.size() << " elements, "
            << body.mesh.vertices.size() << " vertices, " << body.n_nodes()
            << " nodes, " << (body.mesh.is_curved() ? "curved" : "straight")
            << ", volume " << volume_of_body(body) << std::endl;
  check_body(body);
}
} // namespace Setsudan
