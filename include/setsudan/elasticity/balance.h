#pragma once

#include <deal.II/base/index_set.h>

#include <setsudan/elasticity/resultant.h>

#include <vector>

namespace Setsudan
{
/** A force that acts at a point. */
template <int dim>
struct PointForce
{
  dealii::Point<dim> point;
  dealii::Tensor<1, dim> force;
};

/** The balance of a body, and what its supports give back to it. */
template <int dim>
struct BodyBalance : public Balance
{
  dealii::Tensor<1, dim> reaction;
};

/**
 * The balance of all that acts on the body: the loads, the blade and what the
 * supports give back. The blade's forces are taken where the scene puts them
 * and not where they were handed to nodes, so that a mistake on that way shows
 * as well.
 *
 * @param supported  unknowns that a support holds.
 * @param internal   K u (see internal_forces()).
 * @param loads      nodal forces of the loads, without the blade.
 * @param applied    all nodal forces: loads and blade.
 * @param blade      the blade's forces as the scene means them.
 */
template <int dim>
BodyBalance<dim>
check_balance(const Discretization<dim> &discretization,
              const dealii::IndexSet &supported,
              const LA::Vector &internal,
              const LA::Vector &loads,
              const LA::Vector &applied,
              const std::vector<PointForce<dim>> &blade);
} // namespace Setsudan
