// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/contact_drive.h>

#include <optional>

namespace Setsudan
{
/**
 * The blade's edge moves along its direction, and the force is the reaction. A
 * row splits at the travel at which its criterion is met, which is a root and
 * no step: between the breakpoints of the contact everything is linear in the
 * travel, and energies are quadratic. On its path the blade may stop, and be
 * withdrawn, during which no row splits.
 */
template <int dim>
class BladeTravel : public ContactDrive<dim>
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
  /** Follow the travel up to a goal or until rows split; nothing where they do
   * not. */
  std::optional<Split>
  follow(BladeMotion &motion, const double goal);

  /** The state in which the present contacts hold. */
  State<dim>
  solve(CutBody<dim> &body,
        const unsigned int row,
        const BladeMotion &motion,
        const State<dim> &from);

  using ContactDrive<dim>::search;
  using ContactDrive<dim>::cut_contact;
  using ContactDrive<dim>::path;
};
} // namespace Setsudan
