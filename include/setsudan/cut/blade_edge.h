#pragma once

#include <deal.II/base/tensor.h>

#include <setsudan/body/supports.h>
#include <setsudan/cut/blade.h>
#include <setsudan/cut/cut_surface.h>

#include <vector>

namespace Setsudan
{
/** The line in a plane cut along which the blade's edge lies. */
template <int dim>
struct BladeEdge
{
  /** @pre the direction lies in the cut, perpendicular to `normal`. */
  BladeEdge(const dealii::Tensor<1, dim> &normal,
            const dealii::Tensor<1, dim> &direction);

  /** Position along the edge: the coordinate of the axis nearest to the edge;
   * 0 in 2D, where the edge is a point. */
  double
  position(const dealii::Point<dim> &point) const;

  /** The point of the edge line through `origin` at a position. */
  dealii::Point<dim>
  point(const dealii::Point<dim> &origin, const double position) const;

  /** Unit vector along the edge; zero in 2D. */
  dealii::Tensor<1, dim> tangent;
  unsigned int axis = 0;
};

/** A part of a force that one of a row of nodes takes. */
struct NodeShare
{
  unsigned int node;
  double force;
};

/**
 * Hand forces on an edge to the nodes on it by the lever rule: each goes to
 * the two nodes that bracket it, inversely to their distances, which conserves
 * force and moment. A force beyond the last node goes to that node; nodes at
 * the same position share what falls to them.
 *
 * @param nodes positions of the nodes along the edge, ascending.
 */
std::vector<NodeShare>
share_edge_loads(const std::vector<EdgeLoad> &loads,
                 const std::vector<double> &nodes);

/**
 * Whether the blade can make this cut: its direction lies in the surface, it
 * enters at nodes that no support holds, and its loads lie on the edge there.
 *
 * @throw SceneError where one of it is not so.
 */
template <int dim>
void
check_blade(const Parameters &parameters,
            const BladeParameters<dim> &blade,
            const Body<dim> &body,
            const Supports<dim> &supports,
            const CutSurface<dim> &surface);
} // namespace Setsudan
