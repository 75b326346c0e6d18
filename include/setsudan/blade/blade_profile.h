// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <limits>
#include <utility>
#include <vector>

namespace Setsudan
{
/**
 * The cross section of a blade: half of its thickness over the distance s
 * behind the edge, as a polygon. A facet that begins at s_k is the line
 *   h(s) = half_thickness_k + slope_k (s - s_k).
 */
struct BladeProfile
{
  struct Facet
  {
    double begin;
    double half_thickness;
    double slope;
  };

  /** Ascending; none for a blade without a body. The first one begins at the
   * edge. It and the last one are lines without an end, also where they cross
   * the middle of the blade: beyond that nothing keeps walls apart. */
  std::vector<Facet> facets;

  /** How far it keeps walls apart that meet each other instead of facets. */
  double keeps_apart = 0;

  /** How far the blade reaches behind its edge. */
  double length = std::numeric_limits<double>::infinity();

  /** Whether its pressure acts across the cut only, and each facet on what has
   * been so far behind the edge before the body was deformed. A blunt edge
   * would push walls before it, instead of aside, if it pressed normally to
   * itself.
   */
  bool presses_across = false;

  /**
   * A symmetric wedge that ends in a shank.
   *
   * @param angle     between its flanks [degrees], more than 0, less than 180.
   * @param thickness of the shank.
   * @param shoulder_radius with which the flanks turn into the shank: an arc,
   *   in facets of equal angles.
   */
  static BladeProfile
  wedge(const double angle,
        const double thickness,
        const double shoulder_radius);

  /**
   * A polygon that ends in a shank.
   *
   * @param points distances behind the edge and half thicknesses: at least two,
   *   of ascending distances, the first one the edge.
   */
  static BladeProfile
  polygon(const std::vector<std::pair<double, double>> &points);

  /** A circle, of which the edge is the foremost point: a polygon with facets
   * of equal angles. */
  static BladeProfile
  wire(const double diameter);

  /** End the shank at its back, which is chamfered by 45 degrees. */
  void
  end_at(const double height);

  double
  half_thickness(const double s) const;

  /** The largest thickness. */
  double
  thickness() const;

  /** Whether the blade tapers to nothing on a facet: the walls may meet there.
   */
  bool
  is_tip(const unsigned int facet) const;

  /** The facet at a distance behind the edge; ahead of it the first one. */
  unsigned int
  facet_at(const double s) const;
};
} // namespace Setsudan
