// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/surface/cut_surface.h>

#include <vector>

namespace Setsudan
{
/** Where each element is in a body that has been cut. */
struct ElementLabels
{
  /** The side of the newest cut: -1, +1, or 0 where it does not reach. */
  std::vector<int> side;
  /** The separate body it belongs to. */
  std::vector<unsigned int> piece;
};

/**
 * On which side of a cut each element lies: -1 or +1 where the cut's nearest
 * face, counted in elements, is seen from that side, and 0 in pieces that the
 * cut does not reach.
 *
 * @param split the mesh after the surgery, so that no way leads through the
 * cut.
 */
template <int dim>
std::vector<int>
find_sides(const CoarseMesh<dim> &split, const CutSurface<dim> &surface);
} // namespace Setsudan
