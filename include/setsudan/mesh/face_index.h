// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mesh/coarse_mesh.h>

#include <array>
#include <utility>
#include <vector>

namespace Setsudan
{
/** Finds the cells that have a face, by the face's vertices. */
template <int dim>
class FaceIndex
{
public:
  explicit FaceIndex(const CoarseMesh<dim> &mesh);

  /** The one or two cells that have a face, with its number in them, the
   * smaller cell first; empty where there is no such face. */
  std::vector<CellFace>
  find(const EntityKey &key) const;

  /** All faces of all cells, in the order of their keys. */
  const std::vector<std::pair<EntityKey, CellFace>> &
  faces() const;

private:
  std::vector<std::pair<EntityKey, CellFace>> sorted;
};

/** The cell across each face of each cell, or `invalid_unsigned_int`. */
template <int dim>
using Neighbors = std::vector<
  std::array<unsigned int, dealii::GeometryInfo<dim>::faces_per_cell>>;

template <int dim>
Neighbors<dim>
collect_neighbors(const CoarseMesh<dim> &mesh);
} // namespace Setsudan
