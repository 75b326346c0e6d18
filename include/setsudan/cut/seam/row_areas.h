// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/seam/rows.h>
#include <setsudan/cut/seam/surface_strips.h>
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
   * the smaller toughness of the two sides across the faces' mean normals. */
  double energy = 0;
};

/** The area that each row of a cut opens: the strip of the surface from the
 * row's front to that of the next row, the last one to the end.
 *
 * @param strips of the surface. */
template <int dim>
std::vector<RowArea>
row_areas(const std::vector<SurfaceStrip> &strips,
          const Body<dim> &body,
          const CutSurface<dim> &surface,
          const MaterialParameters<dim> &materials,
          const std::vector<Row> &rows);
} // namespace Setsudan
