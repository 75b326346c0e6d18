// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/tensor.h>

#include <setsudan/blade/blade_path.h>
#include <setsudan/blade/blade_profile.h>
#include <setsudan/blade/sliding_blade.h>
#include <setsudan/parameters/parameters.h>

#include <vector>

namespace Setsudan
{
/** A force at a position along the edge. */
struct EdgeLoad
{
  double position;
  double force;
};

/** A point of an edge: its position along the edge, and how far it is behind
 * the foremost one. */
struct EdgePoint
{
  double position;
  double setback;
};

/** The forces on an edge, along the blade's direction. */
struct EdgeLoads
{
  std::vector<EdgeLoad> points;
  /** A force that is spread evenly over the front. */
  double uniform = 0;

  bool
  empty() const
  {
    return points.empty() && uniform == 0;
  }

  /** The whole force. */
  double
  sum() const
  {
    double force = uniform;
    for (const auto &load : points)
      force += load.force;
    return force;
  }
};

/** Subsection `Blade`. */
template <int dim>
struct BladeParameters
{
  double sharpness;
  /** Of a measured edge; 0 where none is given. */
  double edge_radius;
  double thickness;
  /** Whether the edge moves by a travel, and the force is the reaction. */
  bool travels;
  BladePath path;
  /** The longest step of its travel in a body that is not linear; 0: as the
   * rows are. And by how much of what is required a split may exceed it. */
  double advance;
  double advance_tolerance;
  SlidingBlade sliding;
  /** The blade's body. */
  BladeProfile profile;
  /** Unit vectors of the blade's travel, one for each cut or one for all. */
  std::vector<dealii::Tensor<1, dim>> directions;
  /** The loads on the edge, for each cut or for all. */
  std::vector<EdgeLoads> edge_loads;
  /** The edge is a line through these points, and ends as far back as the last
   * ones; none of one that is straight across its way. Ascending. */
  std::vector<EdgePoint> edge_points;

  static void
  declare(dealii::ParameterHandler &handler);

  explicit BladeParameters(const Parameters &parameters);

private:
  void
  read_sliding(const Parameters &parameters);
  void
  read_shape(const Parameters &parameters);
  void
  read_height(const Parameters &parameters);
  void
  read_edge_points(const Parameters &parameters);
};
} // namespace Setsudan
