// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/surface/cut_parameters.h>

#include <string>

namespace Setsudan
{
/** Refuse a surface that is none: that touches no face inside the body, meets
 * itself, or divides nothing.
 *
 * @throw SceneError that says which. */
template <int dim>
void
check_surface(const Parameters &parameters,
              const Body<dim> &body,
              const std::string &text,
              const CutSurface<dim> &surface);

/** Refuse a blade that cannot make a cut: its direction leads across the cut or
 * enters at a support, or its loads lie beyond the edge.
 *
 * @throw SceneError that says which. */
template <int dim>
void
check_blade(const Parameters &parameters,
            const Body<dim> &body,
            const Supports<dim> &supports,
            const Cut<dim> &cut);
} // namespace Setsudan
