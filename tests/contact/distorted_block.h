// SPDX-License-Identifier: LGPL-2.1-or-later
// A small block of distorted elements, for patch tests.
#pragma once

#include <setsudan/parameters/scene_file.h>

#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

/** Write block.msh: 2 elements along each axis of the unit cube or square; the
 * nodes in its middle are moved, those on the cut y = 1/2 in their plane, and
 * the ends y = 0 and y = 1 are the groups `start` and `end`. */
template <int dim>
void
write_block()
{
  constexpr unsigned int n_nodes = dim == 3 ? 27 : 9,
                         n_cells = dim == 3 ? 8 : 4, n_ends = 2 * (dim - 1);
  std::ofstream out("block.msh");
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
      << "$PhysicalNames\n2\n"
      << dim - 1 << " 1 \"start\"\n"
      << dim - 1 << " 2 \"end\"\n$EndPhysicalNames\n"
      << "$Nodes\n"
      << n_nodes << "\n";
  for (unsigned int i = 0; i < n_nodes; ++i)
    {
      const std::array<unsigned int, 3> at{{i % 3, i / 3 % 3, i / 9}};
      out << i + 1;
      for (unsigned int d = 0; d < 3; ++d)
        out << " "
            << at[d] / 2. + (at[d] == 1 && d != 1
                               ? 0.12 * std::sin(3. * i + 2. * d + 1)
                               : 0.);
      out << "\n";
    }
  out << "$EndNodes\n$Elements\n" << n_cells + 2 * n_ends << "\n";
  unsigned int number = 1;
  for (const unsigned int end : {0, 1})
    for (unsigned int f = 0; f < n_ends; ++f)
      {
        const unsigned int first = 1 + 6 * end + f % 2 + 9 * (f / 2);
        out << number++ << (dim == 3 ? " 3 2 " : " 1 2 ") << end + 1 << " 1 "
            << first << " " << first + 1;
        if (dim == 3)
          out << " " << first + 10 << " " << first + 9;
        out << "\n";
      }
  for (unsigned int e = 0; e < n_cells; ++e)
    {
      const unsigned int first = 1 + e % 2 + 3 * (e / 2 % 2) + 9 * (e / 4);
      out << number++ << (dim == 3 ? " 5 2 3 1" : " 3 2 3 1");
      for (unsigned int layer = 0; layer < dim - 1; ++layer)
        for (const unsigned int corner : {0, 1, 4, 3})
          out << " " << first + corner + 9 * layer;
      out << "\n";
    }
  out << "$EndElements\n";
}


/** The block as a scene's body, which widens freely while its end, all else
 * free, comes down by some distance. */
template <int dim>
std::vector<Setsudan::SceneEntry>
pressed_block(const std::string &element_type, const double distance)
{
  return {
    {"Body", "Shape", "file", ""},
    {"Body", "File", "block.msh", ""},
    {"Body", "Element type", element_type, ""},
    {"Support",
     "Fixed boxes",
     dim == 3 ? "-9,-9,-9,0,9,9 : x; -9,-9,-9,9,9,0 : z" : "-9,-9,0,9 : x",
     ""},
    {"Support",
     "Displacements",
     "end : free, -" + std::to_string(distance) + (dim == 3 ? ", free" : ""),
     ""}};
}
