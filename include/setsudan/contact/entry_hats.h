// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/blade/blade_edge.h>
#include <setsudan/blade/blade_profile.h>
#include <setsudan/contact/face_hats.h>
#include <setsudan/cut/seam/seam.h>

#include <functional>
#include <vector>

namespace Setsudan
{
/** A hat on an outer face that a blade's flank may come to touch. */
template <int dim>
struct EntryHat
{
  FaceHat<dim> hat;
  /** The side of the cut that it lies on. */
  bool is_plus;
  /** The mean distance from the cut's plane [length]. */
  double offset;
  /** The mean of how far behind the entry it lies, along the blade's direction
   * [length]. */
  double depth;
};

/**
 * The hats on outer faces of the uncut body that look against a blade which
 * enters between them, as far as it is thick: none unless it is a wedge that
 * presses normally to its flanks and begins with no thickness, and the cut is
 * plane. Hats that would be inside the wedge when its edge is at the entry are
 * left out; those of a groove that it fills are on its flanks. The same on all
 * processes, which all call it.
 *
 * @param uncut the body's mesh before any cut.
 * @param is_there whether an element takes part.
 */
template <int dim>
std::vector<EntryHat<dim>>
entry_hats(const ElasticModel<dim> &model,
           const CoarseMesh<dim> &uncut,
           const Seam<dim> &seam,
           const BladeEdge<dim> &edge,
           const BladeProfile &profile,
           const std::function<bool(unsigned int)> &is_there);

} // namespace Setsudan
