// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/contact/complementarity.h>
#include <setsudan/contact/contact_basis.h>
#include <setsudan/contact/quadratic.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <vector>

namespace Setsudan
{
/** A body under its loads without contact, over the parameter of a path: what
 * the vectors of a basis measure, and its potential energy, up to what is the
 * same in all stages of a cut. */
struct UntouchedBody
{
  LinearInParameter displacements;
  Quadratic energy;
};

/** The body as its contacts know it while the first rows of the cut are split:
 * the vectors of the basis that the stage uses, each at its place, and what
 * they measure without contact and under forces along them. */
template <int dim>
struct ContactStage
{
  using Wall      = typename ContactBasis<dim>::Wall;
  using Component = typename ContactBasis<dim>::Component;

  /**
   * @param basis must live as long.
   * @param row      the first row that is not split; their number behind the
   *   last one.
   * @param n_ahead  the rows behind that one that may split with it.
   * @param products the work of each vector of the basis as a force in the
   *   displacement under each other one, in this stage; of this symmetric
   *   matrix the lower half counts.
   * @param without_contact the body in this stage, with displacements by
   *   vector. */
  ContactStage(const ContactBasis<dim> &basis,
               const unsigned int row,
               const unsigned int n_ahead,
               const dealii::LAPACKFullMatrix<double> &products,
               const UntouchedBody &without_contact);

  /** Where a vector of a hat is. */
  unsigned int
  place_of_hat(const unsigned int hat,
               const Wall wall,
               const Component component) const;

  /** Whether a hat is not supported. */
  bool
  can_move(const unsigned int hat) const;

  const ContactBasis<dim> &basis;
  const unsigned int row;
  /** Where the vectors of the basis are in `products`, and the vector at each
   * place. */
  std::vector<unsigned int> place_of;
  std::vector<unsigned int> vector_at;
  dealii::LAPACKFullMatrix<double> products;
  /** With displacements by place. */
  UntouchedBody untouched;
};
} // namespace Setsudan
