// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/contact/quadratic.h>

namespace Setsudan
{
/** Sums of the forces of contact, over the parameter of a path. */
struct ContactResultants
{
  /** The blade's force along its direction: of the edge, of the flanks, and the
   * parts of the latter that are friction, and that the body does not feel. */
  Quadratic edge;
  Quadratic flanks;
  Quadratic friction;
  Quadratic unfelt;
  /** The force of the blade on the body along its edge. */
  Quadratic aside;
  /** The force of the board on the body along its normal. */
  Quadratic board;
  /** The force with which walls of this cut press on each other, or on a blade
   * without flanks between them. */
  Quadratic walls;
};
} // namespace Setsudan
