// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/tensor.h>

#include <setsudan/body/body.h>

#include <vector>

namespace Setsudan
{
/** An interior element face that a cut opens, as seen from its two sides. */
template <int dim>
struct CutFace
{
  CellFace minus;
  /** The side that the normal of the cut points to. */
  CellFace plus;
};

/** The faces that one cut opens. */
template <int dim>
using CutSurface = std::vector<CutFace<dim>>;

/** The area vectors of faces, as their minus sides have them. */
template <int dim>
std::vector<dealii::Tensor<1, dim>>
areas_of_faces(const Body<dim> &body, const CutSurface<dim> &surface);

/** The sums of the faces' area vectors, which vanishes for a closed surface,
 * and of their areas. */
template <int dim>
struct SurfaceArea
{
  dealii::Tensor<1, dim> vector;
  double area = 0;
};

template <int dim>
SurfaceArea<dim>
measure_surface(const Body<dim> &body, const CutSurface<dim> &surface);

/**
 * A line of the mesh (in 2D a vertex) at which more than two faces of a surface
 * meet, where the surface would have no two sides.
 *
 * @return one point of each such line.
 */
template <int dim>
std::vector<dealii::Point<dim>>
find_branchings(const Body<dim> &body, const CutSurface<dim> &surface);

/**
 * Give faces two consistent sides, by going from each to those that share a
 * line with it. The side that each part of the surface calls plus is that of
 * the larger coordinate of its mean normal's largest component, or the outer
 * one of a closed surface.
 *
 * @param faces pairs of cells' faces, sides as they come.
 * @return whether that is possible: a Möbius strip has one side only.
 */
template <int dim>
bool
orient_surface(const Body<dim> &body, CutSurface<dim> &faces);
} // namespace Setsudan
