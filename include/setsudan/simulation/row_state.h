#pragma once

#include <setsudan/simulation/state.h>

namespace Setsudan
{
/** Whether the division waits for a row to yield. */
template <int dim>
bool
is_judged(const Scene<dim> &scene, const unsigned int row);

/** Solve for the smallest load factor at which a row yields, or the largest
 * allowed one where it does not. The load enters linearly: two solves. */
template <int dim>
State<dim>
solve_ramp(const Scene<dim> &scene,
           CutBody<dim> &body,
           const BladeLoad<dim> &blade,
           const unsigned int row);

/** Set the cutting stress of a state that solve_state() made, and whether the
 * row yields. */
template <int dim>
void
judge(const Scene<dim> &scene,
      CutBody<dim> &body,
      const unsigned int row,
      State<dim> &state);

/**
 * Solve for the body with the blade on a row, and judge whether the row yields.
 *
 * @param guess a displacement near the solution.
 */
template <int dim>
State<dim>
solve_row(const Scene<dim> &scene,
          CutBody<dim> &body,
          const BladeLoad<dim> &blade,
          const double load_factor,
          const LA::Vector &guess);
} // namespace Setsudan
