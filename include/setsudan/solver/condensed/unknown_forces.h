// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/space/linear_algebra.h>

#include <utility>
#include <vector>

namespace Setsudan
{
/** Forces on a few unknowns: each unknown and its force. */
using UnknownForces =
  std::vector<std::pair<dealii::types::global_dof_index, double>>;

/** Forces, the same on all processes, as a vector.
 *
 * @param zero without ghosts, of which this process's entries are set. */
LA::Vector
vector_of(const UnknownForces &forces, LA::Vector zero);

/** The work of each of some forces, which are the same on all processes, in a
 * displacement without ghosts; called by all of them. */
std::vector<double>
work_of(const std::vector<UnknownForces> &forces,
        const LA::Vector &displacement);

/** The forces with which springs resist a displacement without ghosts: along
 * each vector, the same on all processes, its work; called by all of them. */
LA::Vector
spring_forces(const std::vector<UnknownForces> &springs,
              const LA::Vector &displacement);
} // namespace Setsudan
