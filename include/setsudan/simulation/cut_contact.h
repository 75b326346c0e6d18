// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/contact/contact_path.h>
#include <setsudan/simulation/state.h>
#include <setsudan/solver/condensed/condensed_solver.h>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace Setsudan
{
/** The contact of a travelling blade with the newest cut, in all stages of that
 * cut, and of the body with its board, on their Schur complement. */
template <int dim>
class CutContact
{
public:
  /** @param body, profile must live as long.
   * @param displacement in which the body sticks on its board, without ghosts.
   * @throw SolverError where the cut is not solved on its interface. */
  CutContact(CutBody<dim> &body,
             const BladeProfile &profile,
             const LA::Vector &displacement);

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

  /** The same behind the last row, when the blade is gone: what is left is the
   * contact of walls with each other and with the board. */
  std::unique_ptr<ContactPath<dim>>
  path_without_blade(const BladeMotion &motion,
                     const ContactPath<dim> *neighbour);

  /** The state in which the contacts of a path hold at a travel.
   *
   * @param row on which the blade rests.
   * @param guess a displacement near the solution. */
  State<dim>
  state(const ContactPath<dim> &path,
        const unsigned int row,
        const double travel,
        const LA::Vector &guess) const;

private:
  static ContactBasis<dim>
  make_basis(CutBody<dim> &body);

  std::unique_ptr<ContactPath<dim>>
  path(const BladeProfile &profile,
       const unsigned int n_split,
       const unsigned int n_ahead,
       const BladeMotion &motion,
       const ContactPath<dim> *neighbour);

  /** The blade, or the board, as it presses at a travel. */
  BladeLoad<dim>
  blade_load(const ContactPath<dim> &path,
             const unsigned int row,
             const double travel) const;
  std::optional<BoardLoad<dim>>
  board_load(const ContactPath<dim> &path, const double travel) const;

  /** Forces on some vectors of the basis, as forces on the unknowns. */
  std::map<dealii::types::global_dof_index, double>
  on_unknowns(const std::vector<double> &forces,
              const unsigned int begin,
              const unsigned int end) const;

  /** The same as a vector. */
  LA::Vector
  nodal_forces(
    const std::map<dealii::types::global_dof_index, double> &forces) const;

  /** Sum the products up to a stage. */
  void
  advance_products(const unsigned int n_free);

  CutBody<dim> &body;
  const BladeProfile &profile;
  const BladeProfile no_profile;
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
  /** What the vectors measure in the displacement that it began with; empty
   * where there is no board. */
  std::vector<double> measured;
};
/** A body without a cut as it lies on its board.
 *
 * @param from whose displacement is near it. */
template <int dim>
State<dim>
state_on_board(CutBody<dim> &body, const State<dim> &from);
} // namespace Setsudan
