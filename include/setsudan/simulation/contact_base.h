// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/contact/contact_path.h>
#include <setsudan/simulation/state.h>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace Setsudan
{
/** The depth of the shallowest row of the newest cut but the first; the body's
 * extent where there is none. */
template <int dim>
double
shortest_row(const CutBody<dim> &body);

/** The places where a blade may touch the newest cut, and the body its board,
 * and what forces of contact there are on the body. */
template <int dim>
class ContactBase
{
protected:
  /** @param body, profile must live as long.
   * @param displacement in which the body sticks on its board, without ghosts.
   */
  ContactBase(CutBody<dim> &body,
              const BladeProfile &profile,
              const LA::Vector &displacement);

  /** The rows of the newest cut; 0 where there is none. */
  unsigned int
  n_rows() const;

  /** Whether it is of a blade that the scene's forces press in. */
  bool
  has_forces() const;

  /** The contact while the first rows are split, with the blade where it is.
   *
   * @param of_blade no profile where it is gone.
   * @param products of all vectors of the basis in this stage, see
   * ContactStage.
   * @param untouched the body in this stage.
   * @param n_ahead how many rows may split next.
   * @param neighbour one whose contacts may be near; null if there is none. */
  std::unique_ptr<ContactPath<dim>>
  make_path(const BladeProfile &of_blade,
            const unsigned int n_split,
            const unsigned int n_ahead,
            const dealii::LAPACKFullMatrix<double> &products,
            const UntouchedBody &untouched,
            const BladeMotion &motion,
            const ContactPath<dim> *neighbour) const;

  /** The blade as it presses at a travel. */
  BladeLoad<dim>
  blade_load(const ContactPath<dim> &path,
             const unsigned int row,
             const double travel) const;
  /** The board; nothing where there is none. */
  std::optional<BoardLoad<dim>>
  board_load(const ContactPath<dim> &path, const double travel) const;

  /** Say how far a state has passed its board. */
  void
  measure_board(State<dim> &state) const;

  /** Forces on some vectors of the basis, as forces on the unknowns. */
  std::map<dealii::types::global_dof_index, double>
  on_unknowns(const std::vector<double> &forces,
              const unsigned int begin,
              const unsigned int end) const;

  /** The same as a vector. */
  LA::Vector
  nodal_forces(
    const std::map<dealii::types::global_dof_index, double> &forces) const;

  CutBody<dim> &body;
  const BladeProfile &profile;
  const BladeProfile no_profile;
  const ContactBasis<dim> basis;
  /** A travel that is small beside a row. */
  const double step;

private:
  static ContactBasis<dim>
  make_basis(CutBody<dim> &body, const BladeProfile &profile);

  /** Take the forces on outer faces out of those on vectors, as forces at the
   * middle of each hat. */
  void
  add_outer_forces(std::vector<double> &of_vectors,
                   BladeLoad<dim> &blade) const;

  /** What the vectors measure in the displacement that it began with; empty
   * where there is no board. */
  std::vector<double> measured;
};
} // namespace Setsudan
