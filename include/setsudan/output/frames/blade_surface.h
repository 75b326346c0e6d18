// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <setsudan/blade/blade_profile.h>
#include <setsudan/output/frames/vtu.h>

#include <vector>

namespace Setsudan
{
/** Where a blade is: its edge and its axes. */
template <int dim>
struct BladePlace
{
  /** The points of the edge, from end to end; in 2D one. */
  std::vector<dealii::Point<dim>> edge;
  /** Unit vectors of its travel, and across the cut. */
  dealii::Tensor<1, dim> direction;
  dealii::Tensor<1, dim> normal;
  /** How much of it is shown behind the edge. */
  double length;
};

/** The surface of a blade, to be shown beside the body: quadrilaterals, in 2D
 * lines; a sheet where it has no body. */
template <int dim>
VtuGrid
blade_surface(const BladeProfile &profile, const BladePlace<dim> &place);
} // namespace Setsudan
