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
std::string
why_whole(const Scene<dim> &scene, const CutBody<dim> &body)
{
  const auto &output = scene.output;
  if (output.frames == OutputParameters::Frames::every_row ||
      output.node_tables || output.calculix_decks)
    return "since each is written";
  if (scene.accuracy.estimate)
    return "since their errors are estimated";
  if (scene.yield.needs_seam())
    return "since Yield/Criterion looks at all of it";
  if (!body.all_held())
    return "since pieces may come loose";
  if (!body.why_anew().empty())
    return "since every row is solved anew";
  return "";
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



namespace
{
/** The state near the front of the row that the blade stands on, or nothing
 * where that takes a solve for the whole body. */
template <int dim>
std::optional<State<dim>>
solve_near_front(const Scene<dim> &scene,
                 CutBody<dim> &body,
                 const BladeLoad<dim> &blade,
                 const double load_factor)
{
  State<dim> state  = loaded_state(scene, body, blade, load_factor);
  auto displacement = body.displacement_near_front(
    *blade.row, state.forces, prescribed_displacement(body, state));
  if (!displacement)
    return {};
  state.displacement = std::move(*displacement);
  state.is_whole     = false;
  return state;
}
} // namespace


template <int dim>
State<dim>
solve_row(const Scene<dim> &scene,
          CutBody<dim> &body,
          const BladeLoad<dim> &blade,
          const double load_factor,
          const LA::Vector &guess,
          const bool front_is_enough)
{
  const unsigned int row = *blade.row;
  const auto judged      = [&](State<dim> &&state) {
    judge(scene, body, row, state);
    state.yields = state.yields || !is_judged(scene, row);
    return std::move(state);
  };
  if (front_is_enough)
    if (auto near = solve_near_front(scene, body, blade, load_factor))
      {
        auto state = judged(std::move(*near));
        // Where the cut ends the whole body is shown.
        if (state.yields)
          return state;
      }
  return judged(solve_state(scene, body, blade, load_factor, guess));
}



template <int dim>
State<dim>
whole_state(const Scene<dim> &scene,
            CutBody<dim> &body,
            const BladeLoad<dim> &blade,
            const State<dim> &near)
{
  State<dim> state =
    solve_state(scene, body, blade, near.load_factor, near.displacement);
  state.stress = near.stress;
  state.yields = near.yields;
  return state;
}



template bool
is_judged(const Scene<2> &, const unsigned int);
template std::string
why_whole(const Scene<2> &, const CutBody<2> &);
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
          const LA::Vector &,
          const bool);
template State<2>
whole_state(const Scene<2> &,
            CutBody<2> &,
            const BladeLoad<2> &,
            const State<2> &);
template bool
is_judged(const Scene<3> &, const unsigned int);
template std::string
why_whole(const Scene<3> &, const CutBody<3> &);
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
          const LA::Vector &,
          const bool);
template State<3>
whole_state(const Scene<3> &,
            CutBody<3> &,
            const BladeLoad<3> &,
            const State<3> &);
} // namespace Setsudan
