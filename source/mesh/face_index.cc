// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mesh/face_index.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

template <int dim>
FaceIndex<dim>::FaceIndex(const CoarseMesh<dim> &mesh)
{
  sorted.reserve(mesh.cells.size() * GeometryInfo<dim>::faces_per_cell);
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    for (unsigned int f = 0; f < GeometryInfo<dim>::faces_per_cell; ++f)
      sorted.emplace_back(mesh.face_key({cell, f}), CellFace(cell, f));
  std::sort(sorted.begin(), sorted.end());
}



template <int dim>
std::vector<CellFace>
FaceIndex<dim>::find(const EntityKey &key) const
{
  std::vector<CellFace> cells;
  for (auto it = std::lower_bound(
         sorted.begin(), sorted.end(), std::make_pair(key, CellFace(0, 0)));
       it != sorted.end() && it->first == key;
       ++it)
    cells.push_back(it->second);
  return cells;
}



template <int dim>
const std::vector<std::pair<EntityKey, CellFace>> &
FaceIndex<dim>::faces() const
{
  return sorted;
}



template <int dim>
Neighbors<dim>
collect_neighbors(const CoarseMesh<dim> &mesh)
{
  Neighbors<dim> neighbors(mesh.cells.size());
  for (auto &of_cell : neighbors)
    of_cell.fill(numbers::invalid_unsigned_int);
  const FaceIndex<dim> index(mesh);
  const auto &faces = index.faces();
  for (unsigned int i = 0; i + 1 < faces.size(); ++i)
    if (faces[i].first == faces[i + 1].first)
      {
        const auto &[cell, face]        = faces[i].second;
        const auto &[other, other_face] = faces[i + 1].second;
        neighbors[cell][face]           = other;
        neighbors[other][other_face]    = cell;
      }
  return neighbors;
}



template class FaceIndex<2>;
template class FaceIndex<3>;
template Neighbors<2>
collect_neighbors(const CoarseMesh<2> &);
template Neighbors<3>
collect_neighbors(const CoarseMesh<3> &);
} // namespace Setsudan
