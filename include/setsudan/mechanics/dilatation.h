// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/fe/fe_values.h>

#include <setsudan/material/material_parameters.h>
#include <setsudan/mechanics/linear_fit.h>
#include <setsudan/space/discretization.h>

#include <vector>

namespace Setsudan
{
/** The projection of a cell's divergences: linear, but constant for linear
 * elements, which would lock otherwise. */
template <int dim>
LinearFit<dim>
dilatation_fit(const ElementType type, const dealii::FEValues<dim> &fe_values);

/**
 * The dilatation (change of volume per volume, the trace of the strain) of a
 * cell as the mixed formulation has it: the L2 projection of the displacement's
 * divergence onto linear functions of position (see dilatation_fit()).
 *
 * A cell that must keep its volume at each of 27 Gauss points can hardly deform
 * (it locks as Poisson's ratio nears 1/2); one that must keep it in the 4
 * linear moments can. This is the displacement-pressure formulation with a
 * linear pressure in each cell, the pressure eliminated (Simo, Taylor and
 * Pister 1985, Computer Methods in Applied Mechanics and Engineering 51,
 * 177-208). Only the part lambda tr(strain) of the stress takes part in it:
 * what remains, 2 mu strain, resists every motion that is not rigid, so that no
 * spurious mode can arise, in a single free cell neither.
 */
template <int dim>
class Dilatation
{
public:
  using Cell = typename Discretization<dim>::Cell;

  explicit Dilatation(const Discretization<dim> &discretization);

  /** What the stress of a cell of a mixed material depends on besides its
   * strain: its dilatation; with a hyperelastic law the mean Cauchy stress (see
   * MixedCell); with another one of finite strain the volume.
   *
   * @param displacement with ghosts. */
  LinearFunction<dim>
  operator()(const Cell &cell,
             const Material &material,
             const LA::Vector &displacement);

private:
  const ElementType type;
  dealii::FEValues<dim> fe_values;
  std::vector<double> divergences;
  std::vector<dealii::Tensor<2, dim>> gradients;
};
} // namespace Setsudan
