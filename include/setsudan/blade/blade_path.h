// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/parameters/parameters.h>

#include <vector>

namespace Setsudan
{
/** The way of a blade that travels, in each cut anew: where it stops, one after
 * the other, or that it is pushed until the cut is through. */
struct BladePath
{
  struct Stop
  {
    /** Of the edge, along its direction from the entry of the cut [length]. */
    double position;
    /** Of the way from the stop before [time]; 0 where it is not known. */
    double duration;
  };

  /** The first one lies behind the entry; none for a blade that is pushed until
   * the cut is through. */
  std::vector<Stop> stops;
  /** Of all ways whose duration is not given [length/time]; 0 if it is not
   * known. */
  double speed = 0;

  static void
  declare(dealii::ParameterHandler &handler);

  /** @throw SceneError for a path that cannot be one. */
  BladePath(const Parameters &parameters, const bool travels);

  /** Where the way to a stop begins. */
  double
  begin_of(const unsigned int stop) const;

  /** The speed on the way to a stop; 0 if it is not known, or at rest. */
  double
  speed_to(const unsigned int stop) const;

  bool
  has_times() const;

  /** Whether the blade is withdrawn on some way. */
  bool
  turns() const;

private:
  void
  read_stops(const Parameters &parameters);

  /** @throw SceneError for stops that are none. */
  void
  check_stops(const Parameters &parameters) const;
};
} // namespace Setsudan
