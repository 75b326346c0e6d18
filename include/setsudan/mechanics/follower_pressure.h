// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/loads.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

namespace Setsudan
{
/**
 * Pressures under finite strain: they stay normal to the surface as it moves,
 * and act on its present area, -p n da = -p J F^-T N dA (Nanson's formula).
 */
template <int dim>
class FollowerPressure
{
public:
  using Cell = typename Discretization<dim>::Cell;

  /** Both must live as long. */
  FollowerPressure(const Discretization<dim> &discretization,
                   const LoadParameters<dim> &loads);

  /** Integrate over the faces of a cell.
   *
   * @param displacement with ghosts.
   * @return whether any has a pressure; else nothing is set. */
  bool
  reinit(const Cell &cell,
         const LA::Vector &displacement,
         const bool needs_tangent);

  // Of the present cell, in the order of its unknowns.
  dealii::Vector<double> forces;
  /** The derivative of the forces in its symmetric part: with a rim that is
   * held, or on planes of symmetry, the other part cancels over the faces. */
  dealii::FullMatrix<double> tangent;
  /** The energy of the pressure: -p times the change of the volume below the
   * surface, x . n integrated over it and divided by dim. */
  double potential = 0;

private:
  void
  add_face(const double pressure,
           const LA::Vector &displacement,
           const bool needs_tangent);

  const Discretization<dim> &discretization;
  const LoadParameters<dim> &loads;
  /** Whether any face has a pressure. */
  const bool any;
  dealii::FEFaceValues<dim> face_values;
};
} // namespace Setsudan
