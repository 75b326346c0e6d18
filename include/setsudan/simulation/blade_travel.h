// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/cut_contact.h>
#include <setsudan/simulation/drive.h>

#include <memory>
#include <optional>
#include <vector>

namespace Setsudan
{
/**
 * The blade's edge moves along its direction, and the force is the reaction. A
 * row splits at the travel at which its criterion is met, which is a root and
 * no step: between the breakpoints of the contact everything is linear in the
 * travel, and energies are quadratic.
 *
 * With the energy criterion the rows split, one or several at once, that first
 * set free what their new area takes, at fixed travel and with the contact
 * found anew: pushing on an uncut surface is softer than pushing inside, so
 * that a single row might never do.
 */
template <int dim>
class BladeTravel : public Drive<dim>
{
public:
  explicit BladeTravel(const Scene<dim> &scene);

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
  /** Rows that may split together. */
  struct Trial
  {
    unsigned int n_rows;
    double area;
    /** The energy that a slow split takes. */
    double required;
    /** How far the front goes. */
    double length;
    std::unique_ptr<ContactPath<dim>> path;
  };

  CutContact<dim> &
  contact(CutBody<dim> &body);

  std::vector<Trial>
  make_trials(CutBody<dim> &body,
              const unsigned int row,
              const BladeMotion &motion);

  /** How many rows a trial may split. */
  unsigned int
  n_looked_ahead(CutBody<dim> &body, const unsigned int row) const;

  /** What the speed multiplies the toughness with, if so much of the front
   * splits where the blade is. */
  double
  rate_factor(const double length, const BladeMotion &motion) const;

  /** The travel up to `end` at which a trial splits, with the contacts that
   * hold now. */
  std::optional<double>
  travel_of_split(const Trial &trial,
                  const BladeMotion &motion,
                  const double end) const;

  /** Follow the travel until a row splits; the answer is the one that does, and
   * none where that never happens. */
  const Trial *
  follow(std::vector<Trial> &trials, BladeMotion &motion);

  /** The state in which the present contacts hold. */
  State<dim>
  solve(CutBody<dim> &body,
        const unsigned int row,
        const BladeMotion &motion,
        const State<dim> &from);

  const BladeProfile profile;
  std::unique_ptr<CutContact<dim>> cut_contact;
  /** With the rows that are split now. */
  std::unique_ptr<ContactPath<dim>> path;
};
} // namespace Setsudan
