// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/scene.h>

namespace Setsudan
{
/** Check the parameters of a scene's rooms against each other.
 *
 * @throw SceneError for what does not go together. */
template <int dim>
void
check_scene(const Parameters &parameters, const Scene<dim> &scene);
} // namespace Setsudan
