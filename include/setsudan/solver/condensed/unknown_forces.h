// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/types.h>

#include <utility>
#include <vector>

namespace Setsudan
{
/** Forces on a few unknowns: each unknown and its force. */
using UnknownForces =
  std::vector<std::pair<dealii::types::global_dof_index, double>>;
} // namespace Setsudan
