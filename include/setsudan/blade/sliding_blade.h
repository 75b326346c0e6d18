// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace Setsudan
{
/** How a blade slides along the walls and the front of a cut. */
struct SlidingBlade
{
  /** Whether it is held in the middle of the cut; if not it shifts sideways
   * until the walls press on it from both sides alike. */
  bool is_guided = true;
  /** Coulomb's coefficient between flanks and walls. */
  double friction = 0;
  /** The shear strength of their contact [force/length^2]. */
  double adhesion = 0;
  /** How far the blade moves along its edge for each length that it is pushed.
   */
  double slice = 0;
  /** How far the edge drags the front along in that, at most: its friction. */
  double grip = 0;

  double
  drag() const
  {
    return grip < slice ? grip : slice;
  }

  /** Whether the walls resist it. */
  bool
  rubs() const
  {
    return friction > 0 || adhesion > 0;
  }

  /** Whether there is friction along the edge. */
  bool
  rubs_aside() const
  {
    return friction > 0 && slice > 0;
  }
};
} // namespace Setsudan
