// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/state.h>

#include <memory>

namespace Setsudan
{
/**
 * Advances the run: finds the load of a row at which the row is asked whether
 * it yields.
 */
template <int dim>
class Drive
{
public:
  /** The drive that Division/Load control asks for.
   *
   * @param scene must live as long. */
  static std::unique_ptr<const Drive<dim>>
  make(const Scene<dim> &scene);

  explicit Drive(const Scene<dim> &scene);

  virtual ~Drive() = default;

  /**
   * Solve for the body with the blade on a row, and ask whether the row yields.
   *
   * @param from the state before, whose displacement is near the solution.
   */
  virtual State<dim>
  advance(CutBody<dim> &body,
          const BladeLoad<dim> &blade,
          const State<dim> &from) const = 0;

  /** Whether the division waits for a row to yield. */
  bool
  is_checked(const unsigned int row) const;

protected:
  /** The state at a load factor, with its cutting stress. */
  State<dim>
  checked_state(CutBody<dim> &body,
                const BladeLoad<dim> &blade,
                const double load_factor,
                const State<dim> &from) const;

  const Scene<dim> &scene;
};

/** Set the cutting stress of a solved state, and whether the row yields. */
template <int dim>
void
check_yield(CutBody<dim> &body, const unsigned int row, State<dim> &state);
} // namespace Setsudan
