// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/seam/seam.h>

namespace Setsudan
{
/** The force that keeps the walls of a cut a given thickness apart. */
struct OpeningForce
{
  /** On one wall, across the cut; positive where it pushes them apart. */
  double total = 0;
  /** The part of rows that it pulls together, which no blade does; not
   * negative. Single nodes may be pulled where a row is pushed: those at the
   * corners of serendipity elements are, under a uniform pressure. */
  double pull = 0;
};

/**
 * @param states the pairs' states, of which those that are opened count.
 * @param exerted what the constraints exert, without ghosts: the internal less
 *   the external forces.
 */
template <int dim>
OpeningForce
opening_force(const Seam<dim> &seam,
              const PairStates &states,
              const LA::Vector &exerted);
} // namespace Setsudan
