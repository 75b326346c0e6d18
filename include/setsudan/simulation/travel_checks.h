// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/scene.h>

namespace Setsudan
{
/** Refuse what a blade that travels cannot do: be wider than the body, begin
 * inside it, go through its board, or be asked for what its drive does not
 * know.
 *
 * @throw SceneError */
template <int dim>
void
check_travel(const Parameters &parameters, const Scene<dim> &scene);
} // namespace Setsudan
