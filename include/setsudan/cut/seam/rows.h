// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/seam/fronts.h>
#include <setsudan/cut/seam/surface_strips.h>

#include <vector>

namespace Setsudan
{
/** Subsection `Division`: how the cut advances. */
struct DivisionParameters
{
  enum class Release
  {
    node_row,
    element_row,
    face_band
  };
  enum class LoadControl
  {
    constant,
    ramp
  };

  /** What the blade's thickness does to the sides of split rows. */
  enum class SplitRows
  {
    /** It keeps them just so far apart, and may pull as well as push. */
    opened,
    /** It keeps them so far apart at least: it pushes only. */
    wedged,
    /** Nothing. */
    free
  };

  Release release;
  SplitRows split_rows;
  /** In shortest lines of the cut. */
  double row_tolerance;
  LoadControl load_control;
  double max_load_factor;
  /** How many rows may split at once under a blade that travels; 0 for as many
   * as a cut begins with. */
  unsigned int look_ahead;

  static void
  declare(dealii::ParameterHandler &handler);

  explicit DivisionParameters(const Parameters &parameters);
};

/**
 * The rows of a cut, entry first. Nodes that the blade reaches together, up to
 * `tolerance` of the shortest line on the cut, are a layer. Layers are rows of
 * their own, or with `element_row` layers of corner nodes take the mid-side
 * layers behind with them, so that the front always rests on corner nodes.
 * With `face_band` bands of faces take the place of layers (make_bands()).
 *
 * A layer of which the cut divides nothing (the tip of a slit), or whose nodes
 * are all supported (on the board), needs no division: it goes together with
 * the row before it, or with the first one behind.
 *
 * Positions along the edge are coordinates of the axis nearest to it. Where no
 * such axis follows the fronts, because they are closed or run back, positions
 * are lengths along the front, from its end with the smallest coordinate.
 *
 * @param strips of the cut's faces; only `face_band` has a use for them.
 */
template <int dim>
std::vector<Row>
make_rows(const SurfaceNodes<dim> &nodes,
          const BladeEdge<dim> &edge,
          const DivisionParameters &division,
          const std::vector<SurfaceStrip> &strips);
} // namespace Setsudan
