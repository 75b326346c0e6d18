// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/blade/blade_edge.h>
#include <setsudan/cut/surface/cut_surface.h>

#include <array>
#include <vector>

namespace Setsudan
{
/** A part of a face of a cut: its area, and from where to where the blade
 * travels along it, counted from where it enters the cut. */
struct SurfaceStrip
{
  double begin;
  double end;
  double area;
  /** The face in the surface. */
  unsigned int face;
};

/**
 * The faces of a cut in parts, of which the area is taken as evenly spread over
 * the travel along them. That is exact where faces are flat parallelograms
 * along the blade's direction.
 *
 * @param n_cells_on_line of an element: each has four parts along a line, since
 *   it may be curved or lie askew to the blade.
 */
template <int dim>
std::vector<SurfaceStrip>
strips_of_surface(const Body<dim> &body,
                  const CutSurface<dim> &surface,
                  const BladeEdge<dim> &edge,
                  const unsigned int n_cells_on_line);

/** The area that a straight edge opens, over its depth. */
class AreaBehindEdge
{
public:
  explicit AreaBehindEdge(const std::vector<SurfaceStrip> &strips);

  /** How deep an edge is that has opened a part of the whole area, and what
   * part one has opened that is so deep. */
  double
  depth_of(const double part) const;
  double
  part_at(const double depth) const;

private:
  /** Areas, ascending, and depths. */
  std::vector<std::array<double, 2>> points;
};
} // namespace Setsudan
