// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/gmsh_mesh.h>
#include <setsudan/parameters/exceptions.h>

#include <algorithm>
#include <iterator>

namespace Setsudan
{
const GmshType &
gmsh_type(const int number, const std::string &or_else)
{
  static constexpr GmshType types[] = {{"Line 2", 1, 2, 2},
                                       {"Triangle 3", 2, 3, 3},
                                       {"Quadrilateral 4", 2, 4, 4},
                                       {"Tetrahedron 4", 3, 4, 4},
                                       {"Hexahedron 8", 3, 8, 8},
                                       {"Prism 6", 3, 6, 6},
                                       {"Pyramid 5", 3, 5, 5},
                                       {"Line 3", 1, 3, 2},
                                       {"Triangle 6", 2, 6, 3},
                                       {"Quadrilateral 9", 2, 9, 4},
                                       {"Tetrahedron 10", 3, 10, 4},
                                       {"Hexahedron 27", 3, 27, 8},
                                       {"Prism 18", 3, 18, 6},
                                       {"Pyramid 14", 3, 14, 5},
                                       {"Point", 0, 1, 1},
                                       {"Quadrilateral 8", 2, 8, 4},
                                       {"Hexahedron 20", 3, 20, 8},
                                       {"Prism 15", 3, 15, 6},
                                       {"Pyramid 13", 3, 13, 5}};
  if (number < 1 || number > int(std::size(types)))
    throw BodyFileError("there are elements of gmsh's type " +
                        std::to_string(number) +
                        ", which are not of first or second order" + or_else);
  return types[number - 1];
}



void
GmshMesh::sort_nodes()
{
  std::sort(nodes.begin(), nodes.end(), [](const Node &a, const Node &b) {
    return a.number < b.number;
  });
}



const GmshMesh::Node *
GmshMesh::find_node(const std::size_t number) const
{
  if (nodes.empty() || number < nodes.front().number)
    return nullptr;
  // Mostly the numbers have no gaps.
  const std::size_t guess = number - nodes.front().number;
  if (guess < nodes.size() && nodes[guess].number == number)
    return &nodes[guess];
  const auto found =
    std::lower_bound(nodes.begin(),
                     nodes.end(),
                     number,
                     [](const Node &node, const std::size_t wanted) {
                       return node.number < wanted;
                     });
  return found != nodes.end() && found->number == number ? &*found : nullptr;
}
} // namespace Setsudan
