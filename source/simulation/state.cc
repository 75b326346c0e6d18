// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/state.h>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

template <int dim>
State<dim>
rest_state(const CutBody<dim> &body)
{
  State<dim> state;
  state.blade = no_blade(body.model());
  for (LA::Vector *part :
       {&state.displacement, &state.opening, &state.forces, &state.internal})
    *part = body.model().discretization.zero_vector();
  return state;
}



template <int dim>
State<dim>
loaded_state(const CutBody<dim> &body,
             const BladeLoad<dim> &blade,
             const double load_factor,
             const std::optional<BoardLoad<dim>> &board)
{
  State<dim> state  = rest_state(body);
  state.blade       = blade;
  state.load_factor = load_factor;
  state.forces      = body.model().loads;
  state.forces.add(load_factor, blade.nodal_forces);
  state.board = board;
  if (board)
    state.forces += board->nodal_forces;
  state.opening = body.opening();
  return state;
}



template <int dim>
LA::Vector
lift_of(const CutBody<dim> &body, const State<dim> &state)
{
  LA::Vector lift = body.model().lift;
  lift += state.opening;
  return lift;
}



template <int dim>
LA::Vector
all_forces(const State<dim> &state)
{
  LA::Vector forces = state.forces;
  if (state.blade.presses())
    forces += state.blade.pressure;
  return forces;
}



template <int dim>
void
set_solution(const ElasticModel<dim> &model,
             Solution &&solution,
             State<dim> &state)
{
  state.displacement = std::move(solution.displacement);
  state.internal     = std::move(solution.internal);
  state.quality      = solution.quality;
  if (model.is_linear())
    state.strain_energy = state.displacement * state.internal / 2;
  else
    {
      const InternalForces of_laws = evaluate_laws(model, state.displacement);
      state.plastic_energy         = of_laws.energy.plastic;
      state.viscous_energy         = of_laws.energy.viscous;
      state.strain_energy          = of_laws.energy.stored;
      state.pressure_energy        = of_laws.potential_of_pressure;
    }
  state.potential_energy = state.strain_energy + state.pressure_energy -
                           state.forces * state.displacement;
  if (state.board)
    state.potential_energy += state.board->nodal_forces * state.displacement;
}



template <int dim>
double
energy_under_loads(const State<dim> &state)
{
  return state.potential_energy + state.plastic_energy + state.viscous_energy +
         state.load_factor * (state.blade.nodal_forces * state.displacement);
}



template <int dim>
State<dim>
solve_state(CutBody<dim> &body,
            const BladeLoad<dim> &blade,
            const double load_factor,
            const LA::Vector &guess,
            const std::optional<BoardLoad<dim>> &board)
{
  State<dim> state  = loaded_state(body, blade, load_factor, board);
  LA::Vector forces = all_forces(state);
  if (board)
    forces += board->foundation_forces;
  set_solution(body.model(),
               body.solver()->solve(forces, lift_of(body, state), guess),
               state);
  return state;
}



template <int dim>
double
unbalanced_part(const CutBody<dim> &body, const State<dim> &state)
{
  LA::Vector forces = body.model().loads;
  forces.add(state.load_factor, state.blade.nodal_forces);
  forces -= state.internal;
  // A board may do to its nodes what it does, and walls that touch to each
  // other.
  if (body.board())
    {
      IndexSet touching = unknowns_of(body.board()->corners(), forces.size());
      for (const auto &cut : body.earlier_cuts())
        for (const auto &pair : cut.pairs)
          for (const auto *side : {&pair.minus, &pair.plus})
            touching.add_indices(side->begin(), side->end());
      for (const auto unknown : touching)
        if (body.model().discretization.owned.is_element(unknown))
          forces(unknown) = 0;
    }
  const double unbalanced = condense(body.constraints(), forces).l2_norm();
  double all              = state.internal.l2_norm();
  // Where nothing strains the body both are round-off of what it would resist
  // with.
  if (body.model().is_linear() && unbalanced > 1e-10 * all)
    all += internal_forces(body.model(), lift_of(body, state)).l2_norm();
  // Forces that strain a body by less than this are round-off.
  constexpr double no_strain = 1e-6;
  if (!body.model().is_linear())
    all = std::max(all,
                   no_strain * body.scene().material.smallest_youngs_modulus() *
                     std::pow(body.scene().body.mesh.extent(), dim - 1));
  return all > 0 ? unbalanced / all : unbalanced;
}



#define INSTANTIATE(dim)                                                   \
  template State<dim> rest_state(const CutBody<dim> &);                    \
  template State<dim> loaded_state(const CutBody<dim> &,                   \
                                   const BladeLoad<dim> &,                 \
                                   const double,                           \
                                   const std::optional<BoardLoad<dim>> &); \
  template LA::Vector lift_of(const CutBody<dim> &, const State<dim> &);   \
  template LA::Vector all_forces(const State<dim> &);                      \
  template void set_solution(                                              \
    const ElasticModel<dim> &, Solution &&, State<dim> &);                 \
  template State<dim> solve_state(CutBody<dim> &,                          \
                                  const BladeLoad<dim> &,                  \
                                  const double,                            \
                                  const LA::Vector &,                      \
                                  const std::optional<BoardLoad<dim>> &);  \
  template double energy_under_loads(const State<dim> &);                  \
  template double unbalanced_part(const CutBody<dim> &, const State<dim> &);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
