// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mesh/face_index.h>
#include <setsudan/mesh/pieces.h>

#include <algorithm>
#include <set>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Give `number` to all cells that are connected with `first`. */
template <int dim>
void
flood(const Neighbors<dim> &neighbors,
      const unsigned int first,
      const unsigned int number,
      std::vector<unsigned int> &piece)
{
  std::vector<unsigned int> front(1, first);
  piece[first] = number;
  while (!front.empty())
    {
      const unsigned int cell = front.back();
      front.pop_back();
      for (const unsigned int neighbor : neighbors[cell])
        if (neighbor != numbers::invalid_unsigned_int &&
            piece[neighbor] == numbers::invalid_unsigned_int)
          {
            piece[neighbor] = number;
            front.push_back(neighbor);
          }
    }
}
} // namespace


template <int dim>
std::vector<unsigned int>
find_pieces(const CoarseMesh<dim> &mesh,
            const std::vector<unsigned int> &earlier)
{
  const auto neighbors = collect_neighbors(mesh);
  std::vector<unsigned int> piece(mesh.cells.size(),
                                  numbers::invalid_unsigned_int);
  unsigned int next =
    earlier.empty() ? 0 : *std::max_element(earlier.begin(), earlier.end()) + 1;
  std::set<unsigned int> kept;
  for (unsigned int first = 0; first < mesh.cells.size(); ++first)
    if (piece[first] == numbers::invalid_unsigned_int)
      {
        const bool keeps =
          !earlier.empty() && kept.insert(earlier[first]).second;
        flood<dim>(neighbors, first, keeps ? earlier[first] : next++, piece);
      }
  return piece;
}



template std::vector<unsigned int>
find_pieces(const CoarseMesh<2> &, const std::vector<unsigned int> &);
template std::vector<unsigned int>
find_pieces(const CoarseMesh<3> &, const std::vector<unsigned int> &);
} // namespace Setsudan
