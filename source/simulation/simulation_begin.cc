// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/simulation.h>
#include <setsudan/simulation/state_on_board.h>

#include <string>

// The states before the first cut.

namespace Setsudan
{
using namespace dealii;

template <int dim>
void
Simulation<dim>::rest()
{
  state                 = rest_state(body);
  event.required_stress = scene.criterion->smallest_requirement();
  if (scene.accuracy.estimate)
    event.errors = std::array<double, 2>{{0., 0.}};
  if (scene.blade.travels)
    event.motion = BladeMotion();
  if (body.board())
    event.board_force = 0;
  if (scene.material.is_plastic())
    event.plastic_energy = 0;
  if (scene.material.is_viscous())
    event.viscous_energy = 0;
  if (scene.has_time() && !scene.blade.travels)
    event.time = 0;
  results.record("rest", event);
  results.write_state(body, state, event, true);
}



template <int dim>
void
Simulation<dim>::lie()
{
  const auto lying = [&] {
    const TimerOutput::Scope section(timer, "solve");
    return state_on_board(body, state);
  };
  results.progress.info(
    "Board: " + std::to_string(body.board()->corners().size()) +
    " corners of element faces may lie on it.");
  if (!carries_something(*body.board()))
    results.progress.warn(
      "the supports hold all of these corners: the board does nothing. Take "
      "what lies on it out of subsection Support, or leave out Board/Plane.");
  accept(lying(), lying);
  results.record("deform", event);
  results.write_state(body, state, event, true);
}



template <int dim>
void
Simulation<dim>::deform_only()
{
  if (!scene.blade.edge_loads.front().empty())
    results.progress.warn(
      "there is no Cut/Surfaces and so no edge for Blade/Edge loads to act on: "
      "the blade is left out.");
  // On a board, or for a time, it has been deformed already.
  if (body.board() || scene.time.passes())
    return;
  const auto deformed = [&] { return solve(no_blade(body.model()), 0); };
  accept(deformed(), deformed);
  results.record("deform", event);
  results.write_state(body, state, event, true);
}



template <int dim>
unsigned int
Simulation<dim>::open_notch()
{
  const auto &rows     = body.seam().rows();
  const double deepest = (1 + 1e-9) * scene.cut.notch;
  unsigned int row     = 0;
  while (row + 1 < rows.size() &&
         rows[row + 1].depth - rows[0].depth <= deepest)
    release_row(row++);
  if (scene.cut.notch > 0)
    results.progress.info("  notch: " + std::to_string(row) +
                          (row == 1 ? " row is" : " rows are") +
                          " open before the blade comes.");
  return row;
}



#define INSTANTIATE(dim)                               \
  template unsigned int Simulation<dim>::open_notch(); \
  template void Simulation<dim>::rest();               \
  template void Simulation<dim>::lie();                \
  template void Simulation<dim>::deform_only();

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
