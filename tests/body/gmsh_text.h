// SPDX-License-Identifier: LGPL-2.1-or-later
// Small meshes, written as the text of gmsh files of version 2.2.
#pragma once

#include <setsudan/mesh/node_order.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace Setsudan
{
inline std::string
write_text(const std::string &file_name, const std::string &text)
{
  std::ofstream(file_name, std::ios::binary) << text;
  return file_name;
}


inline std::string
read_text(const std::string &file_name)
{
  std::ifstream file(file_name, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}


struct TextMesh
{
  struct Element
  {
    unsigned long number;
    int type, group, entity;
    std::vector<unsigned long> nodes;
  };

  std::map<unsigned long, std::array<double, 3>> nodes;
  std::vector<Element> elements;
  /** One a line: dimension, number, and name in quotes. */
  std::vector<std::string> group_names;

  std::string
  text() const
  {
    std::ostringstream out;
    out.precision(17);
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n"
        << group_names.size() << "\n";
    for (const auto &name : group_names)
      out << name << "\n";
    out << "$EndPhysicalNames\n$Nodes\n" << nodes.size() << "\n";
    for (const auto &[number, position] : nodes)
      out << number << " " << position[0] << " " << position[1] << " "
          << position[2] << "\n";
    out << "$EndNodes\n$Elements\n" << elements.size() << "\n";
    for (const auto &element : elements)
      {
        out << element.number << " " << element.type << " 2 " << element.group
            << " " << element.entity;
        for (const auto node : element.nodes)
          out << " " << node;
        out << "\n";
      }
    out << "$EndElements\n";
    return out.str();
  }

  /** Give all hexahedra and quadrilaterals middle nodes, from `next` on. */
  void
  make_quadratic(unsigned long next)
  {
    std::map<std::pair<unsigned long, unsigned long>, unsigned long> middle;
    for (auto &element : elements)
      if (element.type == 5 || element.type == 3)
        {
          const auto edges =
            element.type == 5 ? gmsh_edges<3>() : gmsh_edges<2>();
          for (const auto &edge : edges)
            {
              const auto ends =
                std::minmax(element.nodes[edge[0]], element.nodes[edge[1]]);
              const auto [line, is_new] = middle.emplace(ends, next);
              if (is_new)
                for (unsigned int d = 0; d < 3; ++d)
                  nodes[next][d] =
                    (nodes.at(ends.first)[d] + nodes.at(ends.second)[d]) / 2;
              next += is_new;
              element.nodes.push_back(line->second);
            }
          element.type = element.type == 5 ? 17 : 16;
        }
  }
};


/** Two cubes, one on the other, from the origin to (1, 1, 2): nodes 1 to 12
 * around the three layers, elements 1 and 2. */
inline TextMesh
two_cubes()
{
  TextMesh mesh;
  for (unsigned long layer = 0; layer < 3; ++layer)
    {
      mesh.nodes[4 * layer + 1] = {{0., 0., double(layer)}};
      mesh.nodes[4 * layer + 2] = {{1., 0., double(layer)}};
      mesh.nodes[4 * layer + 3] = {{1., 1., double(layer)}};
      mesh.nodes[4 * layer + 4] = {{0., 1., double(layer)}};
    }
  mesh.elements    = {{1, 5, 1, 1, {1, 2, 3, 4, 5, 6, 7, 8}},
                      {2, 5, 1, 1, {5, 6, 7, 8, 9, 10, 11, 12}}};
  mesh.group_names = {"3 1 \"cubes\""};
  return mesh;
}


/** Two squares beside each other in the plane z = 0: nodes 1 to 3 below and 4
 * to 6 above, elements 1 and 2. */
inline TextMesh
two_squares()
{
  TextMesh mesh;
  for (unsigned long i = 0; i < 3; ++i)
    {
      mesh.nodes[i + 1] = {{double(i), 0., 0.}};
      mesh.nodes[i + 4] = {{double(i), 1., 0.}};
    }
  mesh.elements    = {{1, 3, 1, 1, {1, 2, 5, 4}}, {2, 3, 1, 1, {2, 3, 6, 5}}};
  mesh.group_names = {"2 1 \"squares\""};
  return mesh;
}
} // namespace Setsudan
