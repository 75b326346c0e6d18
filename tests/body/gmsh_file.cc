// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies from gmsh geometries, and from meshes that gmsh writes of them: all
// types of elements and versions of files, curved lines.

#include <setsudan/body/gmsh/gmsh_file.h>

#include <gmsh.h>

#include <cmath>
#include <map>

#include "../parameters/check.h"
#include "../test_setup.h"
#include "gmsh_bodies.h"
#include "gmsh_text.h"

using namespace Setsudan;
using namespace dealii;

/** A quarter of a ring between radii 1 and 2, in 3D of height 1. */
std::string
quarter_ring(const std::string &options)
{
  return options + R"(
Point(1) = {0, 0, 0};
Point(2) = {1, 0, 0};
Point(3) = {2, 0, 0};
Point(4) = {0, 2, 0};
Point(5) = {0, 1, 0};
Line(1) = {2, 3};
Circle(2) = {3, 1, 4};
Line(3) = {4, 5};
Circle(4) = {5, 1, 2};
Transfinite Curve{2, 4} = 5;
Transfinite Curve{1, 3} = 3;
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
Transfinite Surface{1};
Recombine Surface{1};
e[] = Extrude {0, 0, 1} { Surface{1}; Layers{2}; Recombine; };
Physical Volume("all", 7) = {e[1]};
Physical Volume("soft", 3) = {e[1]};
Physical Surface("bottom", 1) = {1};
Physical Surface(5) = {e[0]};
Physical Curve("edge", 7) = {2};
Physical Point("corner", 7) = {2};
)";
}


const std::string linear = "Mesh.ElementOrder = 1;";
const std::string serendipity =
  "Mesh.ElementOrder = 2; Mesh.SecondOrderIncomplete = 1;";
const std::string complete =
  "Mesh.ElementOrder = 2; Mesh.SecondOrderIncomplete = 0;";


void
test_types()
{
  for (const std::string &options : {linear, serendipity, complete})
    {
      const std::string file = write_text("ring.geo", quarter_ring(options));
      print_size("3D", read_gmsh_file<3>(file));
      const std::string text = quarter_ring(options);
      print_size("2D",
                 read_gmsh_file<2>(
                   write_text("plane.geo", text.substr(0, text.find("e[]")))));
    }
}


/** Let gmsh mesh a geometry and write it in a version of its format. */
void
write_by_gmsh(const std::string &geometry,
              const std::string &mesh,
              const double version,
              const bool binary,
              const unsigned int n_partitions = 0)
{
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::open(geometry);
  gmsh::model::mesh::generate(3);
  if (n_partitions > 0)
    gmsh::model::mesh::partition(n_partitions);
  gmsh::option::setNumber("Mesh.MshFileVersion", version);
  gmsh::option::setNumber("Mesh.Binary", binary);
  gmsh::write(mesh);
  gmsh::finalize();
}


bool
same_groups(const std::vector<Group> &a, const std::vector<Group> &b)
{
  bool same = a.size() == b.size();
  for (unsigned int i = 0; i < a.size() && same; ++i)
    same = a[i].name == b[i].name && a[i].number == b[i].number &&
           a[i].dimension == b[i].dimension && a[i].cells == b[i].cells &&
           a[i].entities == b[i].entities;
  return same;
}


/** The numbers of corners, and those of middle nodes but for where they begin:
 * behind all nodes, of which gmsh writes those of no element or not. */
template <int dim>
bool
same_numbers(const Body<dim> &a, const Body<dim> &b)
{
  constexpr unsigned int n_corners = GeometryInfo<dim>::vertices_per_cell;
  const unsigned int shift =
    a.node_numbers[0][n_corners] - b.node_numbers[0][n_corners];
  bool same = a.node_numbers.size() == b.node_numbers.size();
  for (unsigned int cell = 0; cell < a.node_numbers.size() && same; ++cell)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      same = same && a.node_numbers[cell][node] - b.node_numbers[cell][node] ==
                       (node < n_corners ? 0 : shift);
  return same;
}


template <int dim>
bool
same_bodies(const Body<dim> &a, const Body<dim> &b)
{
  bool same = a.mesh.vertices.size() == b.mesh.vertices.size() &&
              same_numbers(a, b) && a.mesh.is_curved() == b.mesh.is_curved() &&
              same_groups(a.groups, b.groups);
  for (unsigned int cell = 0; cell < a.mesh.cells.size() && same; ++cell)
    {
      same = a.mesh.cells[cell].vertices == b.mesh.cells[cell].vertices;
      for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
        same = same && a.mesh.node_position(cell, node)
                           .distance(b.mesh.node_position(cell, node)) < 1e-15;
    }
  return same;
}


void
test_versions()
{
  for (const std::string &options : {linear, serendipity})
    {
      write_text("versions.geo", quarter_ring(options));
      const auto body = read_gmsh_file<3>("versions.geo");
      for (const double version : {2.2, 4.1})
        for (const bool binary : {false, true})
          {
            write_by_gmsh("versions.geo", "versions.msh", version, binary);
            std::cout << version << (binary ? " binary, " : " text, ");
            check("same body",
                  same_bodies(body, read_gmsh_file<3>("versions.msh")));
          }
    }
}


template <int dim>
void
print_group_sizes(const Body<dim> &body)
{
  for (const auto &group : body.groups)
    std::cout << " '" << group.name << "' " << group.number << ": "
              << group.cells.size() + group.entities.size() << " of dimension "
              << group.dimension << ";";
  std::cout << std::endl;
}


/** The groups that gmsh makes of the borders between the parts of a partitioned
 * mesh are none of the body's. */
void
test_partitions()
{
  std::string geometry = quarter_ring(linear);
  // In version 2.2 gmsh lists what is in two groups once for each.
  const std::string second = "Physical Volume(\"soft\", 3) = {e[1]};\n";
  geometry.erase(geometry.find(second), second.size());
  write_text("parts.geo", geometry);
  std::cout << "whole:";
  print_group_sizes(read_gmsh_file<3>("parts.geo"));
  for (const double version : {2.2, 4.1})
    for (const bool binary : {false, true})
      {
        write_by_gmsh("parts.geo", "parts.msh", version, binary, 3);
        std::cout << version << " in three parts:";
        print_group_sizes(read_gmsh_file<3>("parts.msh"));
      }
}


/** Without a physical volume all volumes are the body, else only these. */
void
test_groups_of_geometry()
{
  const std::string text   = quarter_ring(linear);
  const std::string groups = text.substr(text.find("Physical"));
  const std::string shape =
    text.substr(0, text.find("Physical")) +
    "f[] = Extrude {0, 0, -1} { Surface{1}; Layers{2}; Recombine; };\n";
  print_size("no groups", read_gmsh_file<3>(write_text("parts.geo", shape)));
  print_size("groups",
             read_gmsh_file<3>(write_text("parts.geo", shape + groups)));
  print_size(
    "meshed by itself",
    read_gmsh_file<3>(write_text("parts.geo", shape + groups + "Mesh 3;\n")));
}


/** Middle nodes lie on the inner and outer cylinder where their line's ends do.
 */
void
test_curved()
{
  write_text("curved.geo", quarter_ring(serendipity));
  const auto body  = read_gmsh_file<3>("curved.geo");
  const auto is_at = [](const Point<3> &point, const double radius) {
    return std::abs(std::hypot(point[0], point[1]) - radius) < 1e-10;
  };
  std::map<double, unsigned int> n_right, n_wrong;
  for (unsigned int cell = 0; cell < body.mesh.cells.size(); ++cell)
    for (unsigned int node = 8; node < 20; ++node)
      for (const double radius : {1., 2.})
        {
          const auto nodes = body.mesh.node_positions(cell);
          const auto ends  = vertices_of_node<3>(node);
          if (is_at(nodes[ends[0]], radius) && is_at(nodes[ends[1]], radius))
            ++(is_at(nodes[node], radius) ? n_right : n_wrong)[radius];
        }
  for (const double radius : {1., 2.})
    std::cout << "radius " << radius << ": " << n_right[radius]
              << " middle nodes, " << n_wrong[radius] << " elsewhere"
              << std::endl;
  check_below("volume, error",
              std::abs(volume_of_body(body) / (0.75 * numbers::PI) - 1),
              1e-4);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_types();
    test_versions();
    test_partitions();
    test_groups_of_geometry();
    test_curved();
  });
}
