// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/contact/contact_path.h>
#include <setsudan/simulation/stage_compliance.h>
#include <setsudan/simulation/state.h>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace Setsudan
{
/** The contact of a blade with the newest cut, in all stages of that cut, and
 * of the body with its board, on what forces along the vectors of contact do to
 * each other (StageCompliance): of a blade that travels, or of one that the
 * scene's forces press in, over the load factor. */
template <int dim>
class CutContact
{
public:
  /** @param body, profile must live as long.
   * @param displacement in which the body sticks on its board, without ghosts.
   * @throw SolverError, FloatingPieceError as StageCompliance::make(). */
  CutContact(CutBody<dim> &body,
             const BladeProfile &profile,
             const LA::Vector &displacement);

  /** Whether this is of what the body is now. */
  bool
  is_of_present_body() const
  {
    return compliance->is_of_present_body();
  }

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

  /** The same behind the last row, when the blade is gone: what is left is the
   * contact of walls with each other and with the board. */
  std::unique_ptr<ContactPath<dim>>
  path_without_blade(const BladeMotion &motion,
                     const ContactPath<dim> *neighbour);

  /** Whether the cut can be followed until the blade is gone. */
  bool
  has_last_stage() const
  {
    return last_stage == n_rows(body);
  }

  /** The state in which the contacts of a path hold at a travel or load factor.
   *
   * @param row on which the blade rests.
   * @param guess a displacement near the solution. */
  State<dim>
  state(const ContactPath<dim> &path,
        const unsigned int row,
        const double travel,
        const LA::Vector &guess) const;

private:
  static unsigned int
  n_rows(const CutBody<dim> &body);
  static ContactBasis<dim>
  make_basis(CutBody<dim> &body, const BladeProfile &profile);

  /** Whether it is of a blade that the scene's forces press in. */
  bool
  has_forces() const;

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
  /** Take the forces on outer faces out of those on vectors, as forces at the
   * middle of each hat. */
  void
  add_outer_forces(std::vector<double> &of_vectors,
                   BladeLoad<dim> &blade) const;
  std::optional<BoardLoad<dim>>
  board_load(const ContactPath<dim> &path, const double travel) const;

  /** The blade under the scene's forces, and its pressure. */
  BladeLoad<dim>
  pressing_blade(const ContactPath<dim> &path,
                 const unsigned int row,
                 const double load_factor) const;

  /** @throw InvariantError where walls are in each other's way, or stick to the
   * blade. */
  void
  check(const ContactPath<dim> &path, const State<dim> &state) const;

  /** The body in a stage as the products have it. */
  UntouchedBody
  untouched(const dealii::LAPACKFullMatrix<double> &products,
            const unsigned int n_split) const;

  /** Forces on some vectors of the basis, as forces on the unknowns. */
  std::map<dealii::types::global_dof_index, double>
  on_unknowns(const std::vector<double> &forces,
              const unsigned int begin,
              const unsigned int end) const;

  /** The same as a vector. */
  LA::Vector
  nodal_forces(
    const std::map<dealii::types::global_dof_index, double> &forces) const;

  /** The vectors of the basis, and behind them the scene's forces on the edge
   * in each stage. */
  StageForces
  stage_forces() const;

  CutBody<dim> &body;
  const BladeProfile &profile;
  const BladeProfile no_profile;
  const ContactBasis<dim> basis;
  const unsigned int last_stage;
  /** A travel that is small beside a row. */
  const double step;
  const std::unique_ptr<StageCompliance<dim>> compliance;
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
