// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/accuracy/state_error.h>
#include <setsudan/simulation/checks.h>
#include <setsudan/simulation/messages.h>
#include <setsudan/simulation/simulation.h>

// What follows a solve.

namespace Setsudan
{
using namespace dealii;

template <int dim>
void
Simulation<dim>::take_finite_strain()
{
  body.take_finite_strain();
  drive = Drive<dim>::make(scene, body.model().is_linear());
}



template <int dim>
void
Simulation<dim>::accept(State<dim> &&new_state,
                        const std::function<State<dim>()> &again)
{
  const auto evaluate = [&] {
    const TimerOutput::Scope section(timer, "check state");
    event.frame = n_frames;
    // What was solved for last may be another state, as of a ramp.
    if (!body.model().internal.empty())
      evaluate_laws(body.model(), new_state.displacement);
    return evaluate_state(body, new_state, event);
  };
  const Event last = event;
  auto overlap     = evaluate();
  const bool changes =
    scene.material.strain == LawParameters::Strain::automatic &&
    body.model().is_linear() && event.max_strain > scene.material.linear_range;
  if (changes)
    {
      results.progress.info(describe_change_of_strain(scene.material, event));
      event = last;
      take_finite_strain();
      new_state = again();
      overlap   = evaluate();
    }
  ++n_frames;
  const TimerOutput::Scope section(timer, "check state");
  if (scene.accuracy.estimate)
    {
      const StateError error =
        estimate_error_of_state(body, new_state.blade.row, new_state);
      event.errors = std::array<double, 2>{
        {error.energy.relative_energy, error.cutting_stress}};
      new_state.error_squares = error.energy.squares;
    }
  // Each split can only lower it, as long as the law is the same, and no time
  // passes.
  if (event.released_rows > 0 && !changes &&
      body.model().internal.time_step() == 0)
    check_energy_of_split(body, state, new_state);
  body.accept();
  state = std::move(new_state);
  results.doubt(body, event, state, overlap);
}



#define INSTANTIATE(dim)                               \
  template void Simulation<dim>::take_finite_strain(); \
  template void Simulation<dim>::accept(State<dim> &&, \
                                        const std::function<State<dim>()> &);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
