// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/seam/sides.h>
#include <setsudan/mesh/face_index.h>

#include <deque>

namespace Setsudan
{
using namespace dealii;

template <int dim>
std::vector<int>
find_sides(const CoarseMesh<dim> &split, const CutSurface<dim> &surface)
{
  std::vector<int> side(split.cells.size(), 0);
  std::deque<unsigned int> front;
  const auto reach = [&](const unsigned int element, const int value) {
    if (side[element] == 0)
      {
        side[element] = value;
        front.push_back(element);
      }
  };
  for (const auto &face : surface)
    {
      reach(face.minus.first, -1);
      reach(face.plus.first, +1);
    }
  const auto neighbors = collect_neighbors(split);
  while (!front.empty())
    {
      const unsigned int element = front.front();
      front.pop_front();
      for (const unsigned int neighbor : neighbors[element])
        if (neighbor != numbers::invalid_unsigned_int)
          reach(neighbor, side[element]);
    }
  return side;
}



template std::vector<int>
find_sides(const CoarseMesh<2> &, const CutSurface<2> &);
template std::vector<int>
find_sides(const CoarseMesh<3> &, const CutSurface<3> &);
} // namespace Setsudan
