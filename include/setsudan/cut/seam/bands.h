// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/seam/fronts.h>
#include <setsudan/cut/seam/surface_strips.h>

#include <vector>

namespace Setsudan
{
/**
 * Bands of faces of a cut, in the order in which a straight edge passes their
 * centres, as rows: the pairs that no face touches any more which is not split
 * yet, the lines between split and unsplit faces as the front, and as depth
 * that of the straight edge that has opened the same area.
 *
 * A band is as deep as the deepest face that the edge stands in, up to which
 * the number of faces comes nearest: with less, whole layers of shallow faces
 * would go at once beside single deep ones, so that rows would be of different
 * depths. It begins at the depth of the front, so that what the band before has
 * taken too much or too little does not add up.
 *
 * @param strips    of the cut's faces.
 * @param tolerance in which centres count as passed together.
 */
template <int dim>
std::vector<Row>
make_bands(const SurfaceNodes<dim> &nodes,
           const BladeEdge<dim> &edge,
           const std::vector<SurfaceStrip> &strips,
           const double tolerance);
} // namespace Setsudan
