// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/state.h>

#include <memory>
#include <optional>

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
   * @param scene must live as long.
   * @param is_linear whether the laws of the body are now. */
  static std::unique_ptr<Drive<dim>>
  make(const Scene<dim> &scene, const bool is_linear);

  explicit Drive(const Scene<dim> &scene);

  virtual ~Drive() = default;

  /**
   * Solve for the body with the blade on a row, and ask whether the row yields.
   *
   * @param from the state before, whose displacement is near the solution.
   */
  virtual State<dim>
  advance(CutBody<dim> &body,
          const unsigned int row,
          const State<dim> &from) = 0;

  /** Whether the blade's path goes on from a state in which the row does not
   * yield. */
  bool
  moves_on(const State<dim> &state) const;

  /** The state right behind a split, in which the blade is where it was;
   * nothing where it has gone on to the next row by then.
   *
   * @param row the front now. */
  virtual std::optional<State<dim>>
  settle(CutBody<dim> &body, const unsigned int row, const State<dim> &from);

  /** The state without the blade, behind the last row. */
  virtual State<dim>
  finish(CutBody<dim> &body, const State<dim> &from);

  /** Whether the division waits for a row to yield. */
  bool
  is_checked(const unsigned int row) const;

protected:
  /** The state at a load factor, with its cutting stress. */
  State<dim>
  checked_state(CutBody<dim> &body,
                const unsigned int row,
                const double load_factor,
                const State<dim> &from) const;

  const Scene<dim> &scene;
};

/** Set the cutting stress of a solved state, and whether the row yields. */
template <int dim>
void
check_yield(CutBody<dim> &body, const unsigned int row, State<dim> &state);
} // namespace Setsudan
