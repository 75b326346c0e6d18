// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <setsudan/body/body.h>

#include <array>
#include <set>
#include <utility>
#include <vector>

namespace Setsudan
{
/** A segment in 2D, a triangle in 3D. */
template <int dim>
using Simplex = std::array<dealii::Point<dim>, dim>;

/** Tells which points lie near faces of the mesh. Curved faces are taken as
 * triangles (in 2D segments) between their nodes. */
template <int dim>
class Neighborhood
{
public:
  /** @param width the largest distance from a face that counts. */
  Neighborhood(const Body<dim> &body,
               const std::set<CellFace> &faces,
               const double width);

  bool
  contains(const dealii::Point<dim> &point) const;

private:
  const double width;
  std::vector<Simplex<dim>> simplices;
  /** Boxes around the simplices, larger by the width. */
  dealii::RTree<std::pair<dealii::BoundingBox<dim>, unsigned int>> tree;
};
} // namespace Setsudan
