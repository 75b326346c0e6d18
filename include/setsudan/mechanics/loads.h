// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/tensor.h>

#include <setsudan/parameters/parameters.h>
#include <setsudan/space/discretization.h>

#include <map>
#include <string>
#include <utility>
#include <vector>
namespace Setsudan
{
/**
 * Subsection `Load`: forces that act on the body all the time, besides the
 * blade.
 */
template <int dim>
struct LoadParameters
{
  using Force = dealii::Tensor<1, dim>;

  /** Force per volume. */
  Force body_force;
  struct SurfaceLoad
  {
    /** Positive into the body. */
    double pressure = 0;
    /** Force per area. */
    Force traction;
  };
  /** What acts on faces of the uncut body's surface. */
  std::map<CellFace, SurfaceLoad> surface_loads;
  /** How many faces each item of Pressures and Tractions takes, as the scene
   * has it. */
  std::vector<std::pair<std::string, unsigned int>> surface_items;
  /** Forces on nodes, by the node's number. */
  std::map<unsigned int, Force> nodal_forces;
  static void
  declare(dealii::ParameterHandler &handler);

  /** @throw SceneError for a group or node that does not exist, and for a group
   * that is no part of the body's surface. */
  LoadParameters(const Parameters &parameters, const Body<dim> &body);

  /** Whether the scene has no such load. */
  bool
  empty() const;

  /** Whether it has a pressure. */
  bool
  has_pressure() const;
};

/**
 * The consistent nodal forces of the loads. A force on a node whose copies
 * were separated is shared by them as the elements around it are.
 *
 * @param pressure_follows whether pressures are left to FollowerPressure.
 * @return a vector without ghosts.
 */
template <int dim>
LA::Vector
assemble_loads(const Discretization<dim> &discretization,
               const LoadParameters<dim> &loads,
               const Body<dim> &body,
               const bool pressure_follows = false);
} // namespace Setsudan
