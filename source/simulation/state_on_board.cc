// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/cut_contact.h>
#include <setsudan/simulation/nonlinear_contact.h>
#include <setsudan/simulation/state_on_board.h>

namespace Setsudan
{
template <int dim>
State<dim>
state_on_board(CutBody<dim> &body, const State<dim> &from)
{
  const BladeProfile no_blade;
  State<dim> state;
  if (body.model().is_linear())
    {
      CutContact<dim> contact(body, no_blade, from.displacement);
      state = contact.state(
        *contact.path_without_blade({}, nullptr), 0, 0, from.displacement);
    }
  else
    {
      const NonlinearContact<dim> contact(body, no_blade, from.displacement);
      state = contact.state(contact.begin(0, 0, {}, from.displacement), 0);
    }
  state.motion = from.motion;
  return state;
}



template State<2>
state_on_board(CutBody<2> &, const State<2> &);
template State<3>
state_on_board(CutBody<3> &, const State<3> &);
} // namespace Setsudan
