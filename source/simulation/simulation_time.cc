// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/parameters/exceptions.h>
#include <setsudan/parameters/lists.h>
#include <setsudan/simulation/simulation.h>
#include <setsudan/simulation/state_on_board.h>

#include <algorithm>
#include <cmath>
#include <sstream>

// States at one time after the other.

namespace Setsudan
{
using namespace dealii;

template <int dim>
void
Simulation<dim>::set_time(const double time)
{
  if (event.time)
    event.time = time;
  if (!scene.blade.travels)
    return;
  // The blade has not come yet.
  state.motion                 = BladeMotion();
  state.motion->energy_at_rest = energy_under_loads(state);
  state.motion->time           = time;
  event.motion                 = state.motion;
}



template <int dim>
State<dim>
Simulation<dim>::state_after(const double begin, const double end)
{
  body.set_load_factor(scene.time.load_factor(end));
  body.let_time_pass(end - begin);
  if (!body.board())
    return solve(no_blade(body.model()), 0);
  const TimerOutput::Scope section(timer, "solve");
  return state_on_board(body, state);
}



namespace
{
/** By how much two displacements differ, relative to the largest one. */
double
difference(const LA::Vector &first, const LA::Vector &second)
{
  LA::Vector change = first;
  change -= second;
  const double largest = second.linfty_norm();
  return largest > 0 ? change.linfty_norm() / largest : 0;
}



/** With two digits. */
std::string
rounded(const double value)
{
  std::ostringstream text;
  text.precision(2);
  text << value;
  return text.str();
}



[[noreturn]] void
throw_too_short(const double time, const double tolerance)
{
  throw InvariantError(
    "At the time " + short_text(time) +
    " no step is short enough for Time/Tolerance = " + short_text(tolerance) +
    ": the body springs to another state there, or "
    "Solver/Tolerance is too large for it.");
}
} // namespace


template <int dim>
double
Simulation<dim>::next_step(const double step,
                           const double longest,
                           const std::optional<double> &error) const
{
  if (!error)
    return longest;
  // The error is quadratic in the step.
  const double change = 0.9 * std::sqrt(scene.time.tolerance / *error);
  return std::min(std::clamp(change, 0.2, 2.) * step, longest);
}


template <int dim>
bool
Simulation<dim>::try_step(const double begin,
                          const double end,
                          std::optional<double> &error)
{
  double last            = begin;
  const auto solve_again = [&] { return state_after(last, end); };
  State<dim> next        = solve_again();
  if (scene.time.tolerance > 0)
    {
      const State<dim> before      = state;
      const auto internal_before   = body.model().internal.save();
      const LA::Vector in_one_step = next.displacement;
      last                         = (begin + end) / 2;
      state                        = state_after(begin, last);
      body.accept(state.displacement);
      next  = solve_again();
      error = difference(in_one_step, next.displacement);
      if (*error > scene.time.tolerance)
        {
          body.model().internal.restore(internal_before);
          state = before;
          return false;
        }
    }
  accept(std::move(next), solve_again);
  set_time(end);
  return true;
}



template <int dim>
void
Simulation<dim>::pass_time()
{
  // Of a step that Time/Steps gives.
  constexpr double shortest = 1e-6;
  if (!body.board())
    {
      const auto deformed = [&] { return solve(no_blade(body.model()), 0); };
      accept(deformed(), deformed);
      set_time(0);
      results.record("deform", event);
      results.write_state(body, state, event, true);
    }
  double now           = 0;
  unsigned int n_steps = 0;
  double largest_error = 0;
  for (const auto &[duration, n] : scene.time.spans)
    {
      const double longest = duration / n, begin = now;
      // Of given steps the ends, without what sums of them lose.
      for (double step = longest; now < begin + duration;)
        {
          double next = now + step;
          if (next > begin + duration - 1e-9 * longest)
            next = begin + duration;
          std::optional<double> error;
          const bool is_taken = try_step(now, next, error);
          step                = next_step(next - now, longest, error);
          if (!is_taken && step < shortest * longest)
            throw_too_short(now, scene.time.tolerance);
          if (!is_taken)
            continue;
          now = next;
          ++n_steps;
          largest_error = std::max(largest_error, error.value_or(0));
          results.record("time", event);
          results.write_state(body, state, event, now == begin + duration);
        }
    }
  results.progress.info(
    "Time: " + short_text(now) + " in " + std::to_string(n_steps) +
    (n_steps == 1 ? " step" : " steps") +
    (scene.time.tolerance > 0
       ? "; displacements of a step and its halves differ by " +
           rounded(largest_error) + " of the largest one at most."
       : "."));
}



template <int dim>
void
Simulation<dim>::move_front(const unsigned int row)
{
  const double speed = scene.blade.path.speed;
  if (scene.blade.travels || speed == 0 || !event.time)
    return;
  const double duration =
    body.length_of_rows(event.row, row - event.row) / speed;
  body.let_time_pass(duration);
  set_time(*event.time + duration);
}



#define INSTANTIATE(dim)                                              \
  template double Simulation<dim>::next_step(                         \
    const double, const double, const std::optional<double> &) const; \
  template void Simulation<dim>::pass_time();                         \
  template bool Simulation<dim>::try_step(                            \
    const double, const double, std::optional<double> &);             \
  template State<dim> Simulation<dim>::state_after(const double,      \
                                                   const double);     \
  template void Simulation<dim>::set_time(const double);              \
  template void Simulation<dim>::move_front(const unsigned int);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
