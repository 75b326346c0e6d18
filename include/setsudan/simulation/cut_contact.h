// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/contact/contact_path.h>
#include <setsudan/simulation/state.h>
#include <setsudan/solver/condensed/condensed_solver.h>

#include <memory>
#include <vector>

namespace Setsudan
{
/** The contact of a blade with the newest cut, in all stages of that cut, on
 * its Schur complement: of one that travels, or of one that the scene's forces
 * press in, over the load factor. */
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

  /** The contact while the first rows are split, with the blade where it is;
   * the load factor stands in the place of the travel.
   *
   * @param n_ahead how many rows may split next.
   * @param neighbour one whose contacts may be near; null if there is none. */
  std::unique_ptr<ContactPath<dim>>
  path(const unsigned int n_split,
       const unsigned int n_ahead,
       const BladeMotion &motion,
       const ContactPath<dim> *neighbour);

  /** The blade as it presses at a travel or load factor. */
  BladeLoad<dim>
  load(const ContactPath<dim> &path,
       const unsigned int row,
       const double travel) const;

  /** The body with that blade: solve_state(). */
  State<dim>
  solve(const ContactPath<dim> &path,
        const unsigned int row,
        const double travel,
        const LA::Vector &guess) const;

private:
  /** The forces of contact at a travel or load factor. */
  LA::Vector
  pressure(const ContactPath<dim> &path, const double travel) const;

  /** @throw InvariantError where walls are in each other's way, or stick to the
   * blade. */
  void
  check(const ContactPath<dim> &path, const State<dim> &state) const;

  /** The body in a stage as the products have it. */
  UntouchedBody
  untouched(const unsigned int n_split) const;

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
  /** Of the vectors of the basis, the forces on the edge at each row, and the
   * body's loads, in the first unknowns. */
  dealii::LAPACKFullMatrix<double> products;
  unsigned int n_summed = 0;
};
} // namespace Setsudan
