// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/space/discretization.h>

#include <vector>

namespace Setsudan
{
/** The rigid motions of a body, which elements do not resist: for each its
 * value in the unknowns at these dof_locations, one vector each. */
template <int dim>
std::vector<std::vector<double>>
rigid_modes_at(
  const std::vector<typename Discretization<dim>::DofLocation> &dof_locations);
} // namespace Setsudan
