#pragma once

#include <setsudan/simulation/state.h>

#include <string>

namespace Setsudan
{
/** Whether the division waits for a row to yield. */
template <int dim>
bool
is_judged(const Scene<dim> &scene, const unsigned int row);

/** Why the rows of the newest cut are known in the whole body though
 * Output/Statistics asks for their front only, in words that follow "known in
 * the whole body"; empty where they are known at their front. */
template <int dim>
std::string
why_whole(const Scene<dim> &scene, const CutBody<dim> &body);

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
 * @param guess           a displacement near the solution.
 * @param front_is_enough whether a row that yields may be known near its front
 *   only.
 */
template <int dim>
State<dim>
solve_row(const Scene<dim> &scene,
          CutBody<dim> &body,
          const BladeLoad<dim> &blade,
          const double load_factor,
          const LA::Vector &guess,
          const bool front_is_enough);

/** All of a state that is known near its front only. */
template <int dim>
State<dim>
whole_state(const Scene<dim> &scene,
            CutBody<dim> &body,
            const BladeLoad<dim> &blade,
            const State<dim> &near);
} // namespace Setsudan
