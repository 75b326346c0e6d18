// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/mechanics/resultant.h>

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

/** The balance of a body, and what its supports give to it. */
template <int dim>
struct BodyBalance : public Balance
{
  /** Of the supports that hold still. */
  dealii::Tensor<1, dim> reaction;
  /** Of the clamps that move what they hold. */
  dealii::Tensor<1, dim> clamp_force;
};

/**
 * The balance of all that acts on the body: the loads, the blade and what the
 * supports give back. The blade's forces are taken where the scene puts them
 * and not where they were handed to nodes, so that a mistake on that way shows
 * as well.
 *
 * @param model      its supports give back K u - `applied` where they hold.
 * @param internal   K u (see internal_forces()).
 * @param applied    all nodal forces: loads and blade.
 * @param blade      the blade's forces as the scene means them.
 * @param wedge      the magnitudes, on this process, of the forces by which the
 *   blade's flanks press the two sides of a cut apart: they cancel, and may be
 *   far larger than all others.
 * @param displacement null where it is small; else moments are those about
 *   present positions, and all nodal forces count rather than the scene's.
 */
template <int dim>
BodyBalance<dim>
check_balance(const ElasticModel<dim> &model,
              const LA::Vector &internal,
              const LA::Vector &applied,
              const std::vector<PointForce<dim>> &blade,
              const double wedge             = 0,
              const LA::Vector *displacement = nullptr);
} // namespace Setsudan
