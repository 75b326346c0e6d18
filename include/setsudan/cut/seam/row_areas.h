// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/blade/blade_edge.h>
#include <setsudan/cut/seam/rows.h>
#include <setsudan/cut/surface/cut_surface.h>
#include <setsudan/material/material_parameters.h>

#include <vector>

namespace Setsudan
{
/** The new area of a row, and the energy that it takes. */
struct RowArea
{
  /** Of one side [length^2; in 2D length]. */
  double area = 0;
  /** The energy that this takes with a blade of sharpness 0: the integral of
   * the smaller toughness of the two sides. */
  double energy = 0;
};

/**
 * The area that each row of a cut opens: the strip of the surface from the
 * row's front to that of the next row, the last one to the end. Exact where the
 * faces are flat parallelograms along the blade's direction; elsewhere the area
 * is taken as evenly spread over the travel along a quarter of a face.
 */
template <int dim>
std::vector<RowArea>
row_areas(const Body<dim> &body,
          const MaterialParameters<dim> &materials,
          const CutSurface<dim> &surface,
          const BladeEdge<dim> &edge,
          const std::vector<Row> &rows);
} // namespace Setsudan
