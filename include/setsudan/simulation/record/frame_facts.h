// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/output/frames/frame_content.h>
#include <setsudan/output/tables/statistics.h>
#include <setsudan/simulation/state.h>

#include <memory>

namespace Setsudan
{
/**
 * The data of a state's frame besides its fields: the event, the units, and the
 * blade.
 */
template <int dim>
FrameFacts
frame_facts(const CutBody<dim> &body,
            const State<dim> &state,
            const Event &event,
            const double time);

/** The surface of a blade that travels, beside a state's frame; nothing where
 * there is none. */
template <int dim>
std::shared_ptr<const VtuGrid>
blade_of_state(const CutBody<dim> &body, const State<dim> &state);
} // namespace Setsudan
