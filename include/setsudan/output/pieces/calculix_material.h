// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/material/material_parameters.h>

#include <optional>
#include <string>

namespace Setsudan
{
/**
 * The lines of a deck for CalculiX behind *MATERIAL: *ELASTIC for small strain,
 * *HYPERELASTIC for finite; nothing for a law that CalculiX does not have. Of
 * those of finite strain it has isochoric neo-Hooke, Mooney-Rivlin and Ogden of
 * up to four terms, with the energy of volume (J - 1)^2 / 2.
 */
std::optional<std::string>
calculix_material(const Material &material);

/** The line behind *ORIENTATION, its first two axes, of a material that has
 * axes. */
std::optional<std::string>
calculix_orientation(const Material &material);
} // namespace Setsudan
