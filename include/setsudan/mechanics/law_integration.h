// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/material/finite_strain_law.h>
#include <setsudan/material/small_strain_law.h>
#include <setsudan/mechanics/internal_variables.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Setsudan
{
/** Integrates the forces, the tangent and the energy of one cell after another
 * with whatever laws, by FEValues; of mixed materials see MixedCell. Laws that
 * are all linear have faster ways (see CellBatches and ElementStiffness). */
template <int dim>
class LawIntegration
{
public:
  using Cell = typename Discretization<dim>::Cell;

  /** All must live as long. The trial state of the internal variables is set by
   * reinit(). */
  LawIntegration(const Discretization<dim> &discretization,
                 const MaterialParameters<dim> &materials,
                 InternalVariables<dim> &internal);

  /** Evaluate the laws in a cell, without its tangent.
   *
   * @param displacement with ghosts. */
  void
  reinit(const Cell &cell, const LA::Vector &displacement);

  /**
   * The same with the tangent.
   *
   * With finite strain a step of Newton's method leaves strains of the second
   * order of its rotations, and with them a stress that is far from that of the
   * solution. If the stress that stiffens the body against a change of its
   * direction is instead extrapolated from the state before, linearly along
   * the step, larger steps converge in fewer iterations; at the solution the
   * tangent is the same (the mixed integration point of Magisano, Leonetti and
   * Garcea 2017, Computer Methods in Applied Mechanics and Engineering 313; of
   * mixed materials the mean stress only).
   *
   * @param before a displacement from which the stress in the tangent is
   *   extrapolated, with ghosts; null for the exact tangent.
   */
  void
  reinit_with_tangent(const Cell &cell,
                      const LA::Vector &displacement,
                      const LA::Vector *before);

  // Of the present cell, in the order of its unknowns.
  dealii::Vector<double> forces;
  dealii::FullMatrix<double> tangent;
  /** Where its potential is infinite, forces and tangent are not set. */
  Energy energy;

private:
  using Gradients = std::vector<dealii::Tensor<2, 3>>;

  /** The gradients at the points of the present cell. */
  Gradients
  gradients_of(const LA::Vector &displacement) const;

  /** The response at all points.
   *
   * @param before null where nothing is extrapolated. */
  std::vector<MaterialResponse>
  respond(const ConstitutiveLaw &law,
          const unsigned int cell,
          const Gradients &gradients,
          const Gradients *before,
          const bool needs_tangent) const;

  /** The same of a mixed material; the stiffness of the volume is left to
   * add_volume_stiffness().
   *
   * @param stiffness of the volume at each point; is set. */
  std::vector<MaterialResponse>
  respond_mixed(const DecoupledLaw &law,
                const Gradients &gradients,
                const Gradients *before,
                const bool needs_tangent,
                std::vector<double> &stiffness) const;

  /** The same of a law that remembers, with the volume that MixedCell
   * projects. */
  std::vector<MaterialResponse>
  respond_mixed(const FiniteStrainLaw &law,
                const unsigned int cell,
                const Gradients &gradients,
                const bool needs_tangent,
                std::vector<double> &stiffness) const;

  /** The same of a law of small strain, with the change of volume that
   * Dilatation projects. */
  std::vector<MaterialResponse>
  respond_mixed(const SmallStrainLaw &law,
                const unsigned int cell,
                const Gradients &gradients,
                std::vector<double> &stiffness) const;

  void
  evaluate(const Cell &cell,
           const LA::Vector &displacement,
           const LA::Vector *before,
           const bool needs_tangent);

  /** Add what a point gives to the forces. */
  void
  add_forces(const unsigned int point, const dealii::Tensor<2, 3> &stress);

  /** Add what the laws give to the tangent. */
  void
  add_tangents(const std::vector<MaterialResponse> &responses);

  /** @param gradients at which the change of volume is linearized. */
  void
  add_volume_stiffness(const Gradients &gradients,
                       const std::vector<double> &stiffness);

  const Discretization<dim> &discretization;
  const MaterialParameters<dim> &materials;
  InternalVariables<dim> &internal;
  dealii::FEValues<dim> fe_values;
};
} // namespace Setsudan
