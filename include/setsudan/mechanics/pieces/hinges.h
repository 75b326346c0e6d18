// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/body.h>
#include <setsudan/body/supports.h>

#include <optional>
#include <string>

namespace Setsudan
{
/**
 * Look for a part of the body that can move rigidly although the supports hold
 * the body as a whole: it is joined to the others by a line or a point only, or
 * not at all. Elements that share faces belong to one part.
 *
 * @return where the first such part is, what joins it, and in how many ways it
 * moves; nothing where all parts are held.
 */
template <int dim>
std::optional<std::string>
describe_loose_part(const Body<dim> &body, const Supports<dim> &supports);
} // namespace Setsudan
