// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include <setsudan/material/material_parameters.h>
#include <setsudan/mechanics/dilatation.h>
#include <setsudan/space/cell_shapes.h>

#include <functional>
#include <vector>

namespace Setsudan
{
/**
 * The stiffness matrix of every element (equation 15 of Kakefuda et al. 1996),
 * integrated by Gauss's rule with 3 points in each direction: fewer leave
 * spurious modes in an element that a cut has set free.
 *
 * A cell of the same shape and material as the one before gets the same matrix,
 * so that a box needs one integration only.
 */
template <int dim>
class ElementStiffness
{
public:
  using Cell = typename Discretization<dim>::Cell;

  /** @param materials must live as long. */
  ElementStiffness(const Discretization<dim> &discretization,
                   const MaterialParameters<dim> &materials);

  /** The matrix of a cell, rows in the order of the cell's unknowns. */
  const dealii::FullMatrix<double> &
  operator()(const Cell &cell) const;

  /** How many matrices have been integrated so far. */
  unsigned int
  n_integrations() const;

private:
  void
  integrate(const Cell &cell, const Material &material) const;

  /** Add the lower half of the present cell's matrix, of an isotropic
   * material. */
  void
  add_lower_half(const Hooke &material, const bool is_mixed) const;

  /** The same of any stiffness. */
  void
  add_lower_half(const dealii::SymmetricTensor<4, 3> &stiffness) const;

  /** The change of volume that each shape function makes at each Gauss point
   * of the present cell. */
  std::vector<std::vector<double>>
  dilatations(const bool are_projected) const;

  const Discretization<dim> &discretization;
  const MaterialParameters<dim> &materials;
  // The last cell's matrix is kept.
  mutable dealii::FEValues<dim> fe_values;
  mutable dealii::FullMatrix<double> matrix;
  mutable CellShapes<dim> shapes;
  mutable unsigned int last_material = 0;
  mutable unsigned int integrations  = 0;
};

/**
 * The nodal forces of all cells, with no constraint applied.
 *
 * @param forces_of_cell those of a cell, given with its unknowns and in their
 *   order; null where it has none.
 * @return a vector without ghosts.
 */
template <int dim>
LA::Vector
assemble_forces(
  const Discretization<dim> &discretization,
  const std::function<const dealii::Vector<double> *(
    const typename Discretization<dim>::Cell &,
    const std::vector<dealii::types::global_dof_index> &)> &forces_of_cell);

/**
 * The nodal forces K u by which the elements resist a displacement, with no
 * constraint applied.
 *
 * @param displacement with ghosts.
 * @return a vector without ghosts.
 */
template <int dim>
LA::Vector
internal_forces(const Discretization<dim> &discretization,
                const ElementStiffness<dim> &stiffness,
                const LA::Vector &displacement);

/**
 * Assemble the matrix of the body from those of its cells, condensed with
 * `constraints`.
 *
 * Ties across a cut couple unknowns that no cell of this process has; the
 * constraints' local lines must contain them.
 *
 * @param matrix empty, or from an earlier call with the same constraints.
 */
template <int dim>
void
assemble_matrix(const Discretization<dim> &discretization,
                const std::function<const dealii::FullMatrix<double> &(
                  const typename Discretization<dim>::Cell &)> &matrix_of_cell,
                const dealii::AffineConstraints<double> &constraints,
                LA::SparseMatrix &matrix);

/** The same of the stiffness matrices. */
template <int dim>
void
assemble_stiffness(const Discretization<dim> &discretization,
                   const ElementStiffness<dim> &stiffness,
                   const dealii::AffineConstraints<double> &constraints,
                   LA::SparseMatrix &matrix);
} // namespace Setsudan
