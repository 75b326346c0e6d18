// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/material/given_values.h>
#include <setsudan/material/material_parameters.h>

namespace Setsudan
{
/** The material that an element's values describe.
 *
 * @param laws what the scene says of strain and laws.
 * @throw SceneError for values that do not go together. */
template <int dim>
Material
make_material(const Parameters &parameters,
              const LawParameters &laws,
              const typename GivenValues<dim>::OfElement &values);
} // namespace Setsudan
