// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/material/decoupled_law.h>
#include <setsudan/mechanics/linear_fit.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace Setsudan
{
/**
 * The change of volume and the mean stress of a cell under finite strain in the
 * mixed formulation: both are linear in the position at rest, the volume theta
 * as the L2 projection of J = det F, and the mean stress p as that of
 * U'(theta); the energy stored by the volume is the integral of U(theta). So
 * neither is an unknown of the equations (Simo, Taylor and Pister 1985; see
 * Dilatation for small strains).
 */
template <int dim>
struct MixedCell
{
  /** @param volumes J at the points of the fit, greater than 0. */
  MixedCell(const DecoupledLaw &law,
            const LinearFit<dim> &fit,
            const std::vector<dealii::Point<dim>> &points,
            const std::vector<double> &volumes);

  /** Whether theta is greater than 0 at all points; else nothing else is set.
   */
  bool is_valid = true;
  /** U(theta) and U''(theta) at the points. */
  std::vector<double> energies;
  std::vector<double> stiffness;
  LinearFunction<dim> mean_stress;
};
} // namespace Setsudan
