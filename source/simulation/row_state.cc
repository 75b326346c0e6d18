#include <setsudan/simulation/judgement.h>
#include <setsudan/simulation/row_state.h>

#include <optional>

namespace Setsudan
{
using namespace dealii;

template <int dim>
bool
is_judged(const Scene<dim> &scene, const unsigned int row)
{
  return row == 0 || scene.yield.check == YieldParameters::Check::every_row;
}



template <int dim>
State<dim>
solve_ramp(const Scene<dim> &scene,
           CutBody<dim> &body,
           const BladeLoad<dim> &blade,
           const unsigned int row)
{
  const LA::Vector zero = body.model->discretization.zero_vector();
  State<dim> state      = loaded_state(scene, body, blade, 0);

  const auto equilibrium = body.equilibrium();
  const LA::Vector held  = prescribed_displacement(body, state);
  const Response<dim> base{
    equilibrium->solve(state.forces, held, held), state.forces, held};
  state.quality = equilibrium->quality_of_last();
  const Response<dim> per_load{
    equilibrium->solve(blade.nodal_forces, zero, zero),
    blade.nodal_forces,
    zero};
  state.quality = combine(state.quality, equilibrium->quality_of_last());
  const YieldFactor load =
    find_yield_load(judge_row(scene, body, row, base, &per_load, state.quality),
                    scene.division.max_load_factor);

  state.load_factor = load.load_factor;
  state.stress      = load.stress;
  state.yields      = load.yields;
  state.forces.add(load.load_factor, blade.nodal_forces);
  state.displacement = base.displacement;
  state.displacement.add(load.load_factor, per_load.displacement);
  state.internal = body.internal_forces(state.displacement);
  return state;
}



template <int dim>
void
judge(const Scene<dim> &scene,
      CutBody<dim> &body,
      const unsigned int row,
      State<dim> &state)
{
  const Response<dim> response{
    state.displacement, state.forces, prescribed_displacement(body, state)};
  state.stress =
    judge_row<dim>(scene, body, row, response, nullptr, state.quality)(0);
  state.yields = state.stress.yields();
}



template <int dim>
State<dim>
solve_row(const Scene<dim> &scene,
          CutBody<dim> &body,
          const BladeLoad<dim> &blade,
          const double load_factor,
          const LA::Vector &guess)
{
  const unsigned int row = *blade.row;
  State<dim> state       = solve_state(scene, body, blade, load_factor, guess);
  judge(scene, body, row, state);
  state.yields = state.yields || !is_judged(scene, row);
  return state;
}



template bool
is_judged(const Scene<2> &, const unsigned int);
template State<2>
solve_ramp(const Scene<2> &,
           CutBody<2> &,
           const BladeLoad<2> &,
           const unsigned int);
template void
judge(const Scene<2> &, CutBody<2> &, const unsigned int, State<2> &);
template State<2>
solve_row(const Scene<2> &,
          CutBody<2> &,
          const BladeLoad<2> &,
          const double,
          const LA::Vector &);
template bool
is_judged(const Scene<3> &, const unsigned int);
template State<3>
solve_ramp(const Scene<3> &,
           CutBody<3> &,
           const BladeLoad<3> &,
           const unsigned int);
template void
judge(const Scene<3> &, CutBody<3> &, const unsigned int, State<3> &);
template State<3>
solve_row(const Scene<3> &,
          CutBody<3> &,
          const BladeLoad<3> &,
          const double,
          const LA::Vector &);
} // namespace Setsudan
