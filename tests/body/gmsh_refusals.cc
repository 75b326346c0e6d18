// SPDX-License-Identifier: LGPL-2.1-or-later
// What gmsh files are refused for, each with a sentence.

#include <functional>
#include <limits>

#include "../test_setup.h"
#include "refusals.h"

using namespace Setsudan;
using namespace dealii;

void
test_files()
{
  refuse("missing.msh");
  refuse(".");
  refuse(write_text("empty.msh", ""));
  refuse(write_text("empty.geo", ""));
  refuse(write_text("mesh.vtk", two_cubes().text()));
  refuse_text("Point(1) = {0, 0, 0};\n");
}


/** Files that are not whole, which gmsh might take for smaller meshes. */
void
test_sections()
{
  const std::string text = two_cubes().text();
  refuse_text(replace(text, "2.2", "4"));
  refuse_text(replace(text, "2.2 0 8", "2.2 0"));
  for (const std::string marker : {"$EndMeshFormat",
                                   "$Nodes",
                                   "$EndNodes",
                                   "$Elements",
                                   "2 5 2",
                                   "$EndElements"})
    refuse_text(text.substr(0, text.find(marker)));
  refuse_text(replace(text, "$Nodes", "Nodes"));
  refuse_text(replace(text, "$Elements\n2", "$Elements\n3"));
  refuse_text(replace(text, "1 5 2", "1 5.5 2"));
  refuse_text(replace(text, "1 5 2", "1 92 2"));
  refuse_text(replace(text, "1 5 2", "2 5 2"));
  refuse_text(replace(text, "\n8 0", "\n7 0"));
  refuse_text(replace(text, "\n3 1 \"", "\n4 1 \""));
  // What is left over, or there again, gmsh would not read.
  refuse_text(replace(text, "$Nodes\n12", "$Nodes\n11"));
  refuse_text(replace(text, "$Elements\n2", "$Elements\n1"));
  refuse_text(text + text);
  refuse_text(text + text.substr(text.find("$Elements")));
  refuse_text(text + "$PhysicalNames\n0\n$EndPhysicalNames\n");
}


/** The text of one cube in version 4.1. */
std::string
one_cube_4()
{
  return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 8 1 8\n"
         "3 1 0 8\n1\n2\n3\n4\n5\n6\n7\n8\n"
         "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
         "$EndNodes\n$Elements\n1 1 1 1\n3 1 5 1\n1 1 2 3 4 5 6 7 8\n"
         "$EndElements\n";
}


void
test_sections_of_version_4()
{
  const std::string text = one_cube_4();
  refuse_text(replace(text, "1 8 1 8", "1 8 1 7"));
  refuse_text(replace(text, "1 8 1 8", "1 9 1 8"));
  refuse_text(replace(text, "3 1 0 8", "4 1 0 8"));
  refuse_text(replace(text, "3 1 0 8", "3 1 0 3000000000"));
  refuse_text(replace(text, "1 1 1 1", "1 2 1 1"));
  refuse_text(replace(text, "6 7 8\n$", "6 7 9\n$"));
  refuse_text(replace(text, "6 7 8\n$", "6 7 4000000000\n$"));
  refuse_text(replace(text, "6 7 8\n$", "6 7 8 9\n$"));
  refuse_text(replace(text, "0 1 1\n$", "0 1 1\n5\n$"));
  refuse_text(replace(text, "1 1 1 1", "0 0 1 1"));
  // A volume in a group.
  const std::string volume = "$Entities\n0 0 0 1\n1 0 0 0 1 1 1 1 7 0\n";
  for (const std::string &entities :
       {volume.substr(0, volume.size() - 2) + "\n",
        volume + "5\n",
        replace(volume, "1 7 0", "1 7.5 0"),
        replace(volume, "\n1 0", "\n2 0"),
        replace(volume, "0 0 0 1", "0 0 1 0")})
    refuse_text(replace(text, "$Nodes", entities + "$EndEntities\n$Nodes"));
}


/** The same numbers in binary, as Number. */
template <typename Number>
std::string
bytes_of(const std::vector<Number> &numbers)
{
  return {reinterpret_cast<const char *>(numbers.data()),
          numbers.size() * sizeof(Number)};
}


/** Four nodes and no more are announced, in a binary file of version 2.2. */
void
test_binary_sections()
{
  std::string nodes;
  for (int node = 1; node <= 5; ++node)
    nodes += bytes_of<int>({node}) + bytes_of<double>({1. * node, 0, 0});
  refuse_text("$MeshFormat\n2.2 1 8\n" + bytes_of<int>({1}) +
              "\n$EndMeshFormat\n$Nodes\n4\n" + nodes +
              "\n$EndNodes\n$Elements\n0\n$EndElements\n");
}


void
test_geometries()
{
  refuse(write_text("wrong.geo",
                    "Point(1) = {0, 0, 0};\nPoint(2) = {1, 0, 0};\n"
                    "Line(1) = {1, 2}\nLine(2) = {2, 1};\n"));
  refuse(write_text("wrong.geo", "Point(1) = {0, 0, 0};\nLine(1) = {1, 2};\n"));
  refuse(write_text("wrong.geo", "Point(1) = {0, 0, 0};\n"));
  const std::string cube = "p[] = Extrude {1, 0, 0} { Point{1}; };\n"
                           "l[] = Extrude {0, 1, 0} { Line{p[1]}; };\n"
                           "Extrude {0, 0, 1} { Surface{l[1]}; }\n";
  refuse(write_text("wrong.geo", "Point(1) = {0, 0, 0};\n" + cube));
  refuse<2>(
    write_text("wrong.geo", "Point(1) = {0, 0, 0};\n" + cube + "Mesh 3;\n"));
  refuse<2>(write_text("wrong.geo", "Point(1) = {0, 0, 0};\n" + cube));
}


void
test_types()
{
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    mesh.elements = {{1, 4, 1, 1, {1, 2, 4, 5}},
                     {2, 6, 1, 1, {1, 2, 4, 5, 6, 8}}};
  });
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    mesh.elements[0].type  = 7;
    mesh.elements[0].nodes = {1, 2, 3, 4, 5};
  });
  for (const unsigned int linear : {0, 1})
    refuse_mesh(two_cubes(), [&](TextMesh &mesh) {
      const auto element = mesh.elements[linear];
      mesh.make_quadratic(20);
      mesh.elements[linear] = element;
    });
  refuse_mesh<2>(two_squares(), [](TextMesh &mesh) {
    mesh.elements[0].type  = 2;
    mesh.elements[0].nodes = {1, 2, 4};
  });
  refuse_text<2>(two_cubes().text());
  refuse_text<3>(two_squares().text());
}


void
test_nodes()
{
  refuse_mesh(two_cubes(),
              [](TextMesh &mesh) { mesh.elements[1].nodes[2] = 99; });
  refuse_mesh(two_cubes(),
              [](TextMesh &mesh) { mesh.elements[1].nodes[2] = 13; });
  refuse_mesh(two_cubes(),
              [](TextMesh &mesh) { mesh.elements[1].nodes[2] = 5; });
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    mesh.nodes[4294967297]    = mesh.nodes[12];
    mesh.elements[1].nodes[7] = 4294967297;
  });
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    mesh.make_quadratic(20);
    mesh.elements[0].nodes[12] = mesh.elements[0].nodes[13];
  });
  refuse_mesh<2>(two_squares(), [](TextMesh &mesh) { mesh.nodes[6][2] = 0.1; });
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    mesh.nodes[0]             = mesh.nodes[12];
    mesh.elements[1].nodes[7] = 0;
  });
  refuse_mesh(two_cubes(), [](TextMesh &mesh) { mesh.elements[0].number = 0; });
}


/** Middle nodes that are on their lines, but not in the middle of them. */
void
test_middle_nodes()
{
  for (const double place : {0.25, 0.75, 0.2})
    refuse_mesh(two_cubes(), [&](TextMesh &mesh) {
      mesh.make_quadratic(20);
      mesh.nodes[22][2] = place;
    });
  // As VTK lists them: first around the bottom and the top.
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    mesh.make_quadratic(20);
    for (auto &element : mesh.elements)
      {
        const auto gmsh = element.nodes;
        for (unsigned int i = 0; i < 12; ++i)
          for (unsigned int j = 0; j < 12; ++j)
            {
              const auto vtk = vtk_edges<3>()[i], own = gmsh_edges<3>()[j];
              if (std::minmax(vtk[0], vtk[1]) == std::minmax(own[0], own[1]))
                element.nodes[8 + i] = gmsh[8 + j];
            }
      }
  });
}


void
test_shapes()
{
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    mesh.elements[1].nodes = {9, 10, 11, 12, 5, 6, 7, 8};
  });
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    for (unsigned int node = 9; node <= 12; ++node)
      mesh.nodes[node][2] = 1;
  });
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    mesh.nodes[10] = {{-0.5, 0, 2}};
  });
  refuse_mesh<2>(two_squares(), [](TextMesh &mesh) {
    mesh.nodes[6] = {{1.5, 0.2, 0}};
    mesh.nodes[3] = {{1.2, 0.5, 0}};
  });
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    mesh.make_quadratic(20);
    mesh.nodes[22][2] = 0.76;
  });
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    mesh.make_quadratic(20);
    mesh.nodes[22][0] = 5;
  });
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    mesh.nodes[10][1] = std::numeric_limits<double>::quiet_NaN();
  });
}


/** Elements that do not fit together. */
void
test_neighbors()
{
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    for (unsigned int node = 9; node <= 12; ++node)
      {
        mesh.nodes[node + 10]    = mesh.nodes[node];
        mesh.nodes[node + 10][2] = 1.5;
      }
    mesh.elements.push_back({3, 5, 1, 1, {5, 6, 7, 8, 19, 20, 21, 22}});
  });
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    mesh.elements.push_back(mesh.elements[0]);
    mesh.elements[2].number = 3;
  });
  refuse_mesh<2>(two_squares(), [](TextMesh &mesh) {
    mesh.nodes[7]          = {{0, 0.5, 0}};
    mesh.elements[1].nodes = {7, 2, 5, 4};
  });
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    mesh.make_quadratic(20);
    mesh.nodes[50]            = mesh.nodes[mesh.elements[1].nodes[8]];
    mesh.elements[1].nodes[8] = 50;
  });
  // The second square is below the first, whose lower middle node is a middle
  // node, or a corner, of the second too.
  refuse_mesh<2>(two_squares(), [](TextMesh &mesh) {
    mesh.nodes[7]          = {{0, -1.2, 0}};
    mesh.nodes[8]          = {{1, -1.2, 0}};
    mesh.nodes[9]          = {{1, -0.2, 0}};
    mesh.nodes[10]         = {{0, -0.2, 0}};
    mesh.elements[1].nodes = {7, 8, 9, 10};
    mesh.make_quadratic(20);
    mesh.elements[1].nodes[6] = 20;
    mesh.nodes[20][1]         = -0.1;
  });
  refuse_mesh<2>(two_squares(), [](TextMesh &mesh) {
    const auto second = mesh.elements[1];
    mesh.elements.pop_back();
    mesh.make_quadratic(20);
    mesh.nodes[7] = {{0, -1, 0}};
    mesh.nodes[8] = {{0.5, -1, 0}};
    mesh.elements.push_back(second);
    mesh.elements[1].nodes = {7, 8, 20, 1};
    mesh.make_quadratic(40);
  });
}


void
test_groups()
{
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    mesh.group_names.push_back("2 5 \"lid\"");
    mesh.elements.push_back({3, 3, 5, 1, {1, 2, 7, 8}});
  });
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    mesh.elements.push_back({3, 2, 5, 1, {1, 2, 3}});
  });
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    mesh.elements.push_back({3, 1, 5, 1, {1, 7}});
  });
  refuse_mesh(two_cubes(), [](TextMesh &mesh) {
    mesh.nodes[99] = {{5., 5., 5.}};
    mesh.elements.push_back({3, 15, 5, 1, {99}});
  });
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_files();
    test_sections();
    test_sections_of_version_4();
    test_binary_sections();
    test_geometries();
    test_types();
    test_nodes();
    test_middle_nodes();
    test_shapes();
    test_neighbors();
    test_groups();
  });
}
