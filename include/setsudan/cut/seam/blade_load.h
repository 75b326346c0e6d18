// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/seam/seam.h>
#include <setsudan/mechanics/balance.h>

#include <optional>
#include <vector>

namespace Setsudan
{
/** The blade on a row: its nodal forces at load factor 1, and the forces where
 * the scene puts them. */
template <int dim>
struct BladeLoad
{
  /** Without ghosts. */
  LA::Vector nodal_forces;
  /** A uniform load is in equilibrium with its nodes' forces, which stand here.
   */
  std::vector<PointForce<dim>> forces;
  /** The row on which it stands; nothing where there is no blade. */
  std::optional<unsigned int> row;
  /** Besides, whatever the load factor, the forces by which it presses walls
   * apart and by which these press on each other, which cancel; empty where
   * there are none. Without ghosts. */
  LA::Vector pressure = {};
  /** The part of them that is on one wall of the cut, across it. */
  double opening_force = 0;

  bool
  presses() const
  {
    return pressure.size() > 0;
  }
};

/** The load of a blade that follows the front from a row to the next one, at
 * load factor 1: the change of its nodal forces, and the work that it does on
 * the way between the two fronts of the body at rest. */
struct BladeAdvance
{
  LA::Vector change;
  double work;
};

/** No blade: all forces zero. */
template <int dim>
BladeLoad<dim>
no_blade(const ElasticModel<dim> &model);

/** The blade on the front of a row of a seam.
 *
 * @param edge_loads along the edge, see share_edge_loads(); what is uniform is
 * a load on the lines of the front, with their shape functions. */
template <int dim>
BladeLoad<dim>
blade_on_row(const ElasticModel<dim> &model,
             const Seam<dim> &seam,
             const unsigned int row,
             const dealii::Tensor<1, dim> &direction,
             const EdgeLoads &edge_loads);
} // namespace Setsudan
