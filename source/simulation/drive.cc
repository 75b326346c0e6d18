// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/blade_travel.h>
#include <setsudan/simulation/drive.h>
#include <setsudan/simulation/nonlinear_ramp.h>
#include <setsudan/simulation/nonlinear_travel.h>
#include <setsudan/simulation/wedged_force.h>

namespace Setsudan
{
namespace
{
/** The blade's forces as the scene has them. */
template <int dim>
class ConstantForce : public Drive<dim>
{
public:
  using Drive<dim>::Drive;

  State<dim>
  advance(CutBody<dim> &body,
          const unsigned int row,
          const State<dim> &from) override
  {
    return this->checked_state(body, row, 1, from);
  }
};



/** The blade's forces times the smallest factor at which the row yields, or the
 * largest that is allowed where it does not. A cut that runs through does so at
 * the load that opened it. For linear bodies: two solves. */
template <int dim>
class ForceRamp : public Drive<dim>
{
public:
  using Drive<dim>::Drive;

  State<dim>
  advance(CutBody<dim> &body,
          const unsigned int row,
          const State<dim> &from) override
  {
    return this->is_checked(row)
             ? ramp(body, body.blade_on_row(row))
             : this->checked_state(body, row, from.load_factor, from);
  }

private:
  State<dim>
  ramp(CutBody<dim> &body, const BladeLoad<dim> &blade) const
  {
    const LA::Vector zero   = body.model().discretization.zero_vector();
    State<dim> state        = loaded_state(body, blade, 0);
    const LA::Vector lift   = lift_of(body, state);
    const auto solver       = body.solver();
    Solution base           = solver->solve(state.forces, lift, lift);
    const Solution per_load = solver->solve(blade.nodal_forces, zero, zero);
    SolveQuality quality    = combine(base.quality, per_load.quality);

    const LinearResponse at_base{base.displacement, state.forces, lift, 0};
    const LinearResponse by_load{
      per_load.displacement, blade.nodal_forces, zero, 1};
    const YieldFactor found =
      find_yield_load(this->scene.criterion->evaluate(
                        body, *blade.row, at_base, &by_load, quality),
                      this->scene.division.max_load_factor);

    state.load_factor = found.load_factor;
    state.stress      = found.stress;
    state.yields      = found.yields;
    state.forces.add(found.load_factor, blade.nodal_forces);
    base.displacement.add(found.load_factor, per_load.displacement);
    base.internal.add(found.load_factor, per_load.internal);
    base.quality = quality;
    set_solution(body.model(), std::move(base), state);
    return state;
  }
};
} // namespace


template <int dim>
Drive<dim>::Drive(const Scene<dim> &scene)
  : scene(scene)
{
}



template <int dim>
std::unique_ptr<Drive<dim>>
Drive<dim>::make(const Scene<dim> &scene, const bool is_linear)
{
  if (scene.blade.travels && !is_linear)
    return std::make_unique<NonlinearTravel<dim>>(scene);
  if (scene.blade.travels)
    return std::make_unique<BladeTravel<dim>>(scene);
  if (scene.has_contact())
    return std::make_unique<WedgedForce<dim>>(scene);
  if (scene.division.load_control == DivisionParameters::LoadControl::ramp)
    {
      if (!is_linear)
        return std::make_unique<NonlinearRamp<dim>>(scene);
      return std::make_unique<ForceRamp<dim>>(scene);
    }
  return std::make_unique<ConstantForce<dim>>(scene);
}



template <int dim>
bool
Drive<dim>::moves_on(const State<dim> &state) const
{
  return state.motion && state.motion->n_stops < scene.blade.path.stops.size();
}



template <int dim>
std::optional<State<dim>>
Drive<dim>::settle(CutBody<dim> &, const unsigned int, const State<dim> &)
{
  return {};
}



template <int dim>
State<dim>
Drive<dim>::finish(CutBody<dim> &body, const State<dim> &from)
{
  return solve_state(body, no_blade(body.model()), 0, from.displacement);
}



template <int dim>
bool
Drive<dim>::is_checked(const unsigned int row) const
{
  return row == 0 || scene.yield.check == YieldParameters::Check::every_row;
}



template <int dim>
State<dim>
Drive<dim>::checked_state(CutBody<dim> &body,
                          const unsigned int row,
                          const double load_factor,
                          const State<dim> &from) const
{
  State<dim> state =
    solve_state(body, body.blade_on_row(row), load_factor, from.displacement);
  check_yield(body, row, state);
  state.yields = state.yields || !is_checked(row);
  return state;
}



template <int dim>
void
check_yield(CutBody<dim> &body, const unsigned int row, State<dim> &state)
{
  const LinearResponse response{
    state.displacement, state.forces, lift_of(body, state), state.load_factor};
  state.stress = body.scene().criterion->evaluate(
    body, row, response, nullptr, state.quality)(0);
  state.yields = state.stress.yields();
}



template class Drive<2>;
template class Drive<3>;
template void
check_yield(CutBody<2> &, const unsigned int, State<2> &);
template void
check_yield(CutBody<3> &, const unsigned int, State<3> &);
} // namespace Setsudan
