// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/drive.h>
#include <setsudan/simulation/nonlinear_contact.h>
#include <setsudan/simulation/split_search.h>

#include <memory>
#include <optional>
#include <vector>

namespace Setsudan
{
/**
 * The blade's edge moves along its direction, as BladeTravel, through a body
 * that is not linear: in steps of Blade/Advance at most, and in shorter ones
 * where the force is far from straight or rows are about to split. The travel
 * at which they do lies between that of two equilibria, and is found up to
 * Blade/Advance tolerance of what is required.
 *
 * Of the energy criterion each equilibrium is judged by the equilibria with
 * more rows split and the blade where it is.
 */
template <int dim>
class NonlinearTravel : public Drive<dim>
{
public:
  explicit NonlinearTravel(const Scene<dim> &scene);

  State<dim>
  advance(CutBody<dim> &body,
          const unsigned int row,
          const State<dim> &from) override;

  std::optional<State<dim>>
  settle(CutBody<dim> &body,
         const unsigned int row,
         const State<dim> &from) override;

  /** What the walls had stored they give back to the blade. */
  State<dim>
  finish(CutBody<dim> &body, const State<dim> &from) override;

private:
  using Equilibrium = ContactEquilibrium<dim>;

  /** Where the blade is, and whether rows split there. */
  struct Position
  {
    BladeMotion motion;
    Equilibrium equilibrium;
    /** Whether it has been asked if rows split; how many, what drives them and
     * what is required. */
    bool is_judged       = false;
    unsigned int n_rows  = 1;
    CuttingStress stress = {};
    /** With so many more rows split. */
    std::vector<Equilibrium> trials = {};

    /** By how much what drives exceeds what is required, relative to that. */
    double
    excess() const;

    bool
    yields() const
    {
      return is_judged && excess() >= 0;
    }
  };

  /** Let the contact be of the present cut, and the blade where it is.
   *
   * @param row the first row that is not split. */
  void
  begin(CutBody<dim> &body, const unsigned int row, const State<dim> &from);

  /** Move the blade on.
   *
   * @param time when it is there. */
  Position
  move(CutBody<dim> &body,
       const unsigned int row,
       const Position &from,
       const double travel,
       const double time) const;

  /** The same with the blade's speed. */
  Position
  move(CutBody<dim> &body,
       const unsigned int row,
       const Position &from,
       const double travel) const;

  /** Let the body be somewhere from now on. */
  void
  stay(CutBody<dim> &body, Position &&position);

  /** Let time pass while the blade rests. */
  void
  rest(CutBody<dim> &body, const unsigned int row, const double duration);

  /** What is left of the energy for new surface, and for an excess. */
  double
  energy_set_free(const Position &position, const Equilibrium &after) const;

  /** The energy that a split of rows would set free while the front passes
   * them.
   *
   * @param n how many; a trial is kept for as many where no time passes. */
  double
  try_split(CutBody<dim> &body,
            const unsigned int row,
            const unsigned int n,
            Position &position) const;

  /** Ask whether rows split. */
  void
  judge(CutBody<dim> &body, const unsigned int row, Position &position) const;

  /** Go to the first position up to a goal at which rows split, or to the
   * goal. */
  void
  follow(CutBody<dim> &body, const unsigned int row, const double goal);

  /** An energy beside which others are small: what the next row takes, or the
   * blade's work. */
  double
  energy_of_row(CutBody<dim> &body, const unsigned int row) const;

  /** The next position towards a goal: near enough that the work of the forces
   * in between is what becomes of it. What is missing of that at any distance
   * is an excess. */
  Position
  step(CutBody<dim> &body,
       const unsigned int row,
       const double longest,
       const double goal) const;

  /** How far to go next. */
  double
  next_step(const Position &before,
            const Position &now,
            const double longest) const;

  /** Go to the next stop, or to where rows split.
   *
   * @throw NoEquilibriumError that says where there is none. */
  void
  go_on(CutBody<dim> &body, const unsigned int row);

  /** The position between two, of which rows split at the second only, from
   * which on they do. */
  Position
  locate(CutBody<dim> &body,
         const unsigned int row,
         Position before,
         Position after) const;

  State<dim>
  state(const Position &position, const unsigned int row) const;

  /** How many rows may split at once. */
  unsigned int
  n_ahead(CutBody<dim> &body, const unsigned int row) const;

  const std::unique_ptr<SplitSearch<dim>> search;
  std::unique_ptr<NonlinearContact<dim>> contact;
  /** Whose internal variables have been accepted. */
  std::optional<Position> here;
};
} // namespace Setsudan
