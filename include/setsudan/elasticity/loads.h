#pragma once

#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <setsudan/elasticity/discretization.h>
#include <setsudan/parameters/parameters.h>

#include <map>

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
  /** Pressure on a face of the body, positive into it. */
  std::map<dealii::types::boundary_id, double> pressures;
  /** Force per area of a face. */
  std::map<dealii::types::boundary_id, Force> tractions;
  /** Forces on nodes, by the node's number. */
  std::map<unsigned int, Force> nodal_forces;

  static void
  declare(dealii::ParameterHandler &handler);

  /** @throw SceneError for a face or node that does not exist. */
  LoadParameters(const Parameters &parameters, const Body<dim> &body);

  /** Whether the scene has no such load. */
  bool
  empty() const;
};

/**
 * The consistent nodal forces of the loads. A force on a node whose copies
 * were separated is shared by them as the elements around it are.
 *
 * @return a vector without ghosts.
 */
template <int dim>
LA::Vector
assemble_loads(const Discretization<dim> &discretization,
               const LoadParameters<dim> &loads,
               const Body<dim> &body);
} // namespace Setsudan
