// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/output/frames/frame_content.h>
#include <setsudan/output/tables/statistics.h>
#include <setsudan/simulation/state.h>

namespace Setsudan
{
/**
 * The data of a state's frame besides its fields: the event, the units, and the
 * blade.
 */
template <int dim>
FrameFacts
frame_facts(const CutBody<dim> &body,
            const BladeLoad<dim> &blade,
            const Event &event,
            const double time);
} // namespace Setsudan
