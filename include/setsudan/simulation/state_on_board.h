// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/cut_body.h>
#include <setsudan/simulation/state.h>

namespace Setsudan
{
/** A body without a cut as it lies on its board.
 *
 * @param from whose displacement is near it. */
template <int dim>
State<dim>
state_on_board(CutBody<dim> &body, const State<dim> &from);
} // namespace Setsudan
