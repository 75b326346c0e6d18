// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies from the text of gmsh files: groups, numbers, nodes in one place, and
// cells that the file lists in directions of its own.

#include <setsudan/body/gmsh/gmsh_file.h>

#include <algorithm>
#include <cmath>

#include "../parameters/check.h"
#include "../test_setup.h"
#include "gmsh_bodies.h"
#include "gmsh_text.h"

using namespace Setsudan;
using namespace dealii;

template <int dim>
void
print_groups(const Body<dim> &body)
{
  for (const auto &group : body.groups)
    {
      std::cout << "group '" << group.name << "' " << group.number
                << ", dimension " << group.dimension << ":";
      for (const unsigned int cell : group.cells)
        std::cout << " " << cell;
      for (const auto &entity : group.entities)
        {
          std::cout << " (";
          for (unsigned int i = 0; i < n_vertices(entity); ++i)
            std::cout << (i > 0 ? " " : "") << entity[i];
          std::cout << ")";
        }
      std::cout << std::endl;
    }
}


void
test_groups()
{
  auto mesh               = two_cubes();
  mesh.group_names        = {"3 1 \"lower\"",
                             "3 2 \"the upper one\"",
                             "2 1 \"lower\"",
                             "1 4 \"edge\"",
                             "2 9 \"nothing\""};
  mesh.elements[1].group  = 2;
  mesh.elements[1].entity = 2;
  mesh.elements.push_back({11, 3, 1, 1, {4, 3, 2, 1}});
  mesh.elements.push_back({12, 3, 8, 2, {12, 9, 10, 11}});
  mesh.elements.push_back({13, 1, 4, 1, {10, 9}});
  mesh.elements.push_back({14, 15, 4, 1, {12}});
  print_groups(read_gmsh_file<3>(write_text("groups.msh", mesh.text())));

  // In version 2.2 what is in two groups is listed twice.
  mesh.elements.push_back({15, 5, 5, 1, {1, 2, 3, 4, 5, 6, 7, 8}});
  mesh.elements.push_back({16, 3, 6, 1, {4, 3, 2, 1}});
  const auto body = read_gmsh_file<3>(write_text("groups.msh", mesh.text()));
  print_groups(body);
  print_size("two groups", body);

  // Groups can have parts of an entity.
  mesh                   = two_cubes();
  mesh.elements[1].group = 2;
  mesh.elements.push_back({11, 3, 5, 1, {4, 3, 2, 1}});
  mesh.elements.push_back({12, 3, 6, 1, {12, 9, 10, 11}});
  print_groups(read_gmsh_file<3>(write_text("groups.msh", mesh.text())));
}


/** Groups of version 4.1 are those of the entities; where these are not listed
 * there are none, and one that is turned round is the same. */
void
test_groups_of_version_4()
{
  const std::string entities =
    "$Entities\n0 0 2 1\n5 0 0 0 1 1 0 2 9 -4 0\n6 0 0 0 1 1 0 1 8 0\n"
    "1 0 0 0 1 1 1 1 -7 1 5\n$EndEntities\n";
  const std::string elements =
    "$Elements\n2 2 1 2\n2 5 3 1\n2 1 2 3 4\n3 1 5 1\n1 1 2 3 4 5 6 7 8\n"
    "$EndElements\n";
  const std::string nodes =
    "$Nodes\n1 8 1 8\n3 1 0 8\n1\n2\n3\n4\n5\n6\n7\n8\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n$EndNodes\n";
  const std::string format = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  print_groups(read_gmsh_file<3>(
    write_text("groups.msh", format + entities + nodes + elements)));
  print_groups(
    read_gmsh_file<3>(write_text("groups.msh", format + nodes + elements)));
}


/** Cubes of separate nodes where they touch. */
void
test_coincident()
{
  auto mesh = two_cubes();
  for (unsigned int node = 5; node <= 8; ++node)
    {
      mesh.nodes[node + 20]            = mesh.nodes[node];
      mesh.elements[1].nodes[node - 5] = node + 20;
    }
  print_size("linear",
             read_gmsh_file<3>(write_text("coincident.msh", mesh.text())));
  mesh.make_quadratic(30);
  print_size("quadratic",
             read_gmsh_file<3>(write_text("coincident.msh", mesh.text())));
}


template <int dim>
void
print_numbers(const Body<dim> &body)
{
  for (const auto &of_element : body.node_numbers)
    {
      std::cout << "nodes:";
      for (const unsigned int number : of_element)
        std::cout << " " << number;
      std::cout << std::endl;
    }
}


/** Nodes are where the file says, in whatever direction a cell is listed. */
template <int dim>
void
test_directions(TextMesh mesh,
                const std::vector<unsigned long> &first,
                const std::vector<unsigned long> &second)
{
  mesh.elements[0].nodes = first;
  mesh.elements[1].nodes = second;
  print_size("linear",
             read_gmsh_file<dim>(write_text("directions.msh", mesh.text())));
  mesh.make_quadratic(20);
  for (auto &[number, position] : mesh.nodes)
    if (number >= 20)
      position[0] += 0.001 * number;
  const auto body =
    read_gmsh_file<dim>(write_text("directions.msh", mesh.text()));
  print_size("quadratic", body);
  double error = 0;
  for (unsigned int cell = 0; cell < body.mesh.cells.size(); ++cell)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      for (unsigned int d = 0; d < dim; ++d)
        error =
          std::max(error,
                   std::abs(body.mesh.node_position(cell, node)[d] -
                            mesh.nodes.at(body.node_numbers[cell][node])[d]));
  check_below("positions, error", error, 1e-15);
}


/** The file's order of elements and numbers; middle nodes that it does not have
 * follow its largest number, which is that of a node of no element here. */
void
test_numbers()
{
  auto mesh               = two_cubes();
  mesh.nodes[90]          = {{7., 7., 7.}};
  mesh.nodes[100]         = {{7., 7., 7.}};
  mesh.elements[0].number = 9;
  const auto body = read_gmsh_file<3>(write_text("numbers.msh", mesh.text()));
  print_numbers(body);
  std::cout << "nodes of no element:";
  for (const unsigned int number : body.unused_nodes)
    std::cout << " " << number;
  std::cout << std::endl;
  auto squares = two_squares();
  print_numbers(read_gmsh_file<2>(write_text("numbers.msh", squares.text())));
  squares.make_quadratic(50);
  print_numbers(read_gmsh_file<2>(write_text("numbers.msh", squares.text())));
}


/** Line ends of Windows. */
void
test_line_ends()
{
  std::string text;
  for (const char c : two_cubes().text())
    text += c == '\n' ? "\r\n" : std::string(1, c);
  print_size("line ends of Windows",
             read_gmsh_file<3>(write_text("windows.msh", text)));
  print_size("a geometry with a byte order mark",
             read_gmsh_file<2>(write_text(
               "windows.geo",
               "\xEF\xBB\xBF// K\u00F6rper\r\n"
               "Point(1) = {0, 0, 0};\r\n"
               "l[] = Extrude {1, 0, 0} { Point{1}; Layers{2}; };\r\n"
               "Extrude {0, 1, 0} { Curve{l[1]}; Layers{2}; "
               "Recombine; }\r\n")));
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_groups();
    test_groups_of_version_4();
    test_coincident();
    // Clockwise and counterclockwise, and with lines against each other.
    test_directions<2>(two_squares(), {1, 2, 5, 4}, {5, 6, 3, 2});
    test_directions<2>(two_squares(), {4, 5, 2, 1}, {6, 5, 2, 3});
    test_directions<3>(
      two_cubes(), {1, 2, 3, 4, 5, 6, 7, 8}, {7, 8, 5, 6, 11, 12, 9, 10});
    test_directions<3>(
      two_cubes(), {1, 5, 6, 2, 4, 8, 7, 3}, {6, 10, 11, 7, 5, 9, 12, 8});
    test_numbers();
    test_line_ends();
  });
}
