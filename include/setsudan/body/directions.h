// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/body.h>

namespace Setsudan
{
// In which order a cell lists its corners is free within limits, and deal.II
// has wishes. These functions change the order, and with it all that a body
// knows of its cells' nodes; shapes and numbers stay.

/** List the corners of quadrilaterals such that their Jacobian is positive.
 * Hexahedra stay: for them it is a matter of shape. */
template <int dim>
void
make_counterclockwise(Body<dim> &body);

/** Turn cells such that opposite lines have the same direction, and lines have
 * one direction in all cells. deal.II needs this in 2D and likes it in 3D,
 * where it is not always possible. */
template <int dim>
void
make_lines_consistent(Body<dim> &body);
} // namespace Setsudan
