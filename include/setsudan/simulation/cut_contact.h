// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/contact_base.h>
#include <setsudan/simulation/stage_compliance.h>

#include <memory>

namespace Setsudan
{
/** The contact of a blade with the newest cut, in all stages of that cut, and
 * of the body with its board, on what forces along the vectors of contact do to
 * each other (StageCompliance): of a blade that travels, or of one that the
 * scene's forces press in, over the load factor. */
template <int dim>
class CutContact : private ContactBase<dim>
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
    return last_stage == this->n_rows();
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

  /** The vectors of the basis, and behind them the scene's forces on the edge
   * in each stage. */
  StageForces
  stage_forces() const;

  using ContactBase<dim>::body;
  using ContactBase<dim>::profile;
  using ContactBase<dim>::basis;
  const unsigned int last_stage;
  const std::unique_ptr<StageCompliance<dim>> compliance;
};
} // namespace Setsudan
