// SPDX-License-Identifier: LGPL-2.1-or-later
// A block of hexahedra as a file of gmsh's, whose nodes are anywhere.
#pragma once

#include <deal.II/base/point.h>

#include <array>
#include <fstream>
#include <functional>
#include <string>

/** @param n        numbers of elements along the axes.
 * @param position of the node at three indices. */
inline void
write_block(
  const std::string &name,
  const std::array<unsigned int, 3> &n,
  const std::function<dealii::Point<3>(const std::array<unsigned int, 3> &)>
    &position)
{
  std::ofstream out(name);
  out.precision(17);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n"
      << (n[0] + 1) * (n[1] + 1) * (n[2] + 1) << "\n";
  unsigned int number = 1;
  for (unsigned int k = 0; k <= n[2]; ++k)
    for (unsigned int j = 0; j <= n[1]; ++j)
      for (unsigned int i = 0; i <= n[0]; ++i)
        out << number++ << " " << position({{i, j, k}}) << "\n";
  out << "$EndNodes\n$Elements\n" << n[0] * n[1] * n[2] << "\n";
  const unsigned int along_y = n[0] + 1, along_z = along_y * (n[1] + 1);
  number = 1;
  for (unsigned int k = 0; k < n[2]; ++k)
    for (unsigned int j = 0; j < n[1]; ++j)
      for (unsigned int i = 0; i < n[0]; ++i)
        {
          const unsigned int first = 1 + i + j * along_y + k * along_z;
          out << number++ << " 5 2 1 1";
          for (const unsigned int layer : {0u, along_z})
            for (const unsigned int corner : {0u, 1u, along_y + 1, along_y})
              out << " " << first + corner + layer;
          out << "\n";
        }
  out << "$EndElements\n";
}
