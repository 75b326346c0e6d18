// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/tensor.h>

#include <setsudan/blade/blade.h>

#include <vector>

namespace Setsudan
{
/** How the blade lies in a cut: the way that it travels and the direction of
 * its edge. */
template <int dim>
struct BladeEdge
{
  /**
   * The blade's direction is projected into the cut: onto the plane that the
   * sum of the faces' areas stands on. A surface that is closed, or nearly so
   * like a cup, has no such plane: where the projection would not bring the
   * direction nearer to the faces it is left as it is.
   *
   * @param areas the area vectors of the faces.
   * @param points of an edge that is not straight, or not square to its way:
   *   see BladeParameters.
   */
  BladeEdge(const std::vector<dealii::Tensor<1, dim>> &areas,
            const dealii::Tensor<1, dim> &direction,
            const std::vector<EdgePoint> &points = {});

  /** How far the blade travels until its edge comes to a point, from wherever.
   */
  double
  travel(const dealii::Point<dim> &point) const;

  /** Position along the edge: the coordinate of the axis nearest to the edge;
   * 0 in 2D, where the edge is a point. */
  double
  position(const dealii::Point<dim> &point) const;

  /** Unit vector of the blade's travel in the cut. */
  dealii::Tensor<1, dim> direction;
  /** By which angle the projection turned it [degrees]. */
  double projection_angle = 0;
  /** The angle between it and the faces, whose sine is the mean over their
   * areas [degrees]. */
  double angle_to_faces = 0;
  /** Whether the surface has a plane, along which the edge lies. */
  bool is_planar = false;
  /** The unit normal of that plane, towards the plus side; where there is none
   * it means nothing. */
  dealii::Tensor<1, dim> normal;
  /** The axis nearest to the edge. */
  unsigned int axis = 0;
  /** Ascending; none of an edge that is straight across its way. */
  std::vector<EdgePoint> points;
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
} // namespace Setsudan
