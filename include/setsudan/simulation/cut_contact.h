// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/contact/contact_path.h>
#include <setsudan/simulation/cut_body.h>
#include <setsudan/solver/condensed/condensed_solver.h>

#include <memory>
#include <vector>

namespace Setsudan
{
/** The contact of a travelling blade with the newest cut, in all stages of that
 * cut, on its Schur complement. */
template <int dim>
class CutContact
{
public:
  /** @param body, profile must live as long.
   * @throw SolverError where the cut is not solved on its interface. */
  CutContact(CutBody<dim> &body, const BladeProfile &profile);

  /** Whether this is of what the body is now. */
  bool
  is_of(CutBody<dim> &body) const;

  /** The contact while the first rows are split, with the blade where it is.
   *
   * @param n_ahead how many rows may split next.
   * @param neighbour one whose contacts may be near; null if there is none. */
  std::unique_ptr<ContactPath<dim>>
  path(const unsigned int n_split,
       const unsigned int n_ahead,
       const BladeMotion &motion,
       const ContactPath<dim> *neighbour);

  /** The blade as it presses at a travel. */
  BladeLoad<dim>
  load(const ContactPath<dim> &path,
       const unsigned int row,
       const double travel) const;

private:
  /** Sum the products up to a stage. */
  void
  advance_products(const unsigned int n_free);

  CutBody<dim> &body;
  const BladeProfile &profile;
  const ContactBasis<dim> basis;
  const std::shared_ptr<CondensedSolver<dim>> solver;
  /** The free unknowns of each stage. */
  std::vector<unsigned int> n_free;
  /** A travel that is small beside a row. */
  const double step;
  typename CondensedSolver<dim>::Compliance compliance;
  /** Of the vectors in the first unknowns. */
  dealii::LAPACKFullMatrix<double> products;
  unsigned int n_summed = 0;
};
} // namespace Setsudan
