#include <setsudan/elasticity/strain_recovery.h>
#include <setsudan/simulation/mechanics.h>

#include <sstream>

namespace Setsudan
{
using namespace dealii;

template <int dim>
BladeLoad<dim>
no_blade(const CutBody<dim> &body)
{
  return {body.model->discretization.zero_vector(), {}};
}



template <int dim>
BladeLoad<dim>
blade_on_row(const Scene<dim> &scene,
             const CutBody<dim> &body,
             const unsigned int row)
{
  const auto &pairs     = body.seam().pairs();
  const auto &front     = body.seam().rows()[row].front;
  const auto &direction = scene.blade.direction;
  const BladeEdge<dim> edge(pairs[front.front()].normal, direction);
  std::vector<double> positions;
  for (const unsigned int pair : front)
    positions.push_back(edge.position(pairs[pair].position));

  BladeLoad<dim> blade = no_blade(body);
  for (const auto &share : share_edge_loads(scene.blade.edge_loads, positions))
    for (unsigned int c = 0; c < dim; ++c)
      {
        // The front is tied: a force on one side acts on both.
        const auto index = pairs[front[share.node]].minus[c];
        if (blade.nodal_forces.in_local_range(index))
          blade.nodal_forces(index) += share.force * direction[c];
      }
  blade.nodal_forces.compress(VectorOperation::add);
  for (const auto &load : scene.blade.edge_loads)
    blade.forces.push_back(
      {edge.point(pairs[front.front()].position, load.position),
       load.force * direction});
  return blade;
}



template <int dim>
State<dim>
rest_state(const CutBody<dim> &body)
{
  const LA::Vector zero = body.model->discretization.zero_vector();
  return {zero, zero, zero};
}



template <int dim>
State<dim>
solve_state(const Scene<dim> &scene,
            CutBody<dim> &body,
            const BladeLoad<dim> &blade,
            const double load_factor,
            const LA::Vector &guess)
{
  const auto constraints = body.constraints();
  State<dim> state       = rest_state(body);
  state.load_factor      = load_factor;
  state.forces           = body.model->loads;
  state.forces.add(load_factor, blade.nodal_forces);
  if (!body.seams.empty())
    state.opening =
      body.seam().opening(body.model->discretization, scene.blade.thickness);
  state.displacement = Equilibrium<dim>(*body.model, constraints, scene.solver)
                         .solve(state.forces, state.opening, guess);
  return state;
}



template <int dim>
State<dim>
solve_ramp(const Scene<dim> &scene,
           CutBody<dim> &body,
           const BladeLoad<dim> &blade,
           const unsigned int row)
{
  const auto &discretization = body.model->discretization;
  const auto constraints     = body.constraints();
  const LA::Vector zero      = discretization.zero_vector();
  State<dim> state           = rest_state(body);
  state.opening = body.seam().opening(discretization, scene.blade.thickness);

  Equilibrium<dim> equilibrium(*body.model, constraints, scene.solver);
  const LA::Vector base =
    equilibrium.solve(body.model->loads, state.opening, state.opening);
  const LA::Vector per_load = equilibrium.solve(blade.nodal_forces, zero, zero);
  const auto stresses       = [&](const LA::Vector &displacement) {
    return front_stresses(*body.model,
                          body.seam(),
                          body.seam().rows()[row],
                          discretization.with_ghosts(displacement));
  };
  const YieldLoad load = find_yield_load(
    stresses(base),
    stresses(per_load),
    required_stress(scene.material.shear_limit, scene.blade.sharpness),
    scene.division.max_load_factor,
    body.communicator);

  state.load_factor    = load.load_factor;
  state.cutting_stress = load.cutting_stress;
  state.yields         = load.yields;
  state.displacement   = base;
  state.displacement.add(load.load_factor, per_load);
  state.forces = body.model->loads;
  state.forces.add(load.load_factor, blade.nodal_forces);
  return state;
}



template <int dim>
void
judge(const Scene<dim> &scene,
      const CutBody<dim> &body,
      const unsigned int row,
      State<dim> &state)
{
  state.cutting_stress = cutting_stress(
    front_stresses(*body.model,
                   body.seam(),
                   body.seam().rows()[row],
                   body.model->discretization.with_ghosts(state.displacement)),
    body.communicator);
  state.yields =
    yields(state.cutting_stress,
           required_stress(scene.material.shear_limit, scene.blade.sharpness));
}



namespace
{
template <int dim>
LA::Vector
internal_forces_of(CutBody<dim> &body, const LA::Vector &displacement)
{
  return internal_forces(body.model->discretization,
                         body.model->stiffness,
                         body.model->discretization.with_ghosts(displacement));
}
} // namespace


template <int dim>
void
describe_state(const Scene<dim> &scene,
               CutBody<dim> &body,
               const BladeLoad<dim> &blade,
               const State<dim> &state,
               Event &event)
{
  const auto &discretization = body.model->discretization;
  const LA::Vector internal  = internal_forces_of(body, state.displacement);

  event.load_factor    = state.load_factor;
  event.blade_force    = 0;
  event.cutting_stress = state.cutting_stress;
  event.required_stress =
    required_stress(scene.material.shear_limit, scene.blade.sharpness);
  event.strain_energy = 0.5 * (state.displacement * internal);
  event.potential_energy =
    event.strain_energy - state.forces * state.displacement;
  event.pieces = body.n_pieces();

  const auto extremes =
    find_extremes(discretization,
                  body.model->material,
                  discretization.with_ghosts(state.displacement));
  event.min_jacobian     = extremes.min_jacobian;
  event.max_strain       = extremes.max_strain;
  event.max_shear        = extremes.max_shear;
  event.max_displacement = extremes.max_displacement;

  std::vector<PointForce<dim>> forces = blade.forces;
  for (auto &force : forces)
    {
      force.force *= state.load_factor;
      event.blade_force += force.force * scene.blade.direction;
    }
  const auto balance    = check_balance(discretization,
                                     body.model->supported,
                                     internal,
                                     body.model->loads,
                                     state.forces,
                                     forces);
  event.force_residual  = balance.force_residual;
  event.moment_residual = balance.moment_residual;
  for (unsigned int d = 0; d < dim; ++d)
    event.reaction[d] = balance.reaction[d];
  const double tolerance = std::max(1e-8, 100 * scene.solver.tolerance);
  if (!(balance.force_residual <= tolerance &&
        balance.moment_residual <= tolerance))
    {
      std::ostringstream message;
      message << "The forces on the body are not in balance: the relative "
                 "residuals of force and moment are "
              << balance.force_residual << " and " << balance.moment_residual
              << " and must not exceed " << tolerance
              << ". Lower Solver/Tolerance or set Solver/Method = direct.";
      throw SolverError(message.str());
    }
}



template <int dim>
void
check_energy_of_split(CutBody<dim> &body,
                      const State<dim> &before,
                      const State<dim> &after)
{
  const LA::Vector internal = internal_forces_of(body, after.displacement);
  const double energy_after =
    0.5 * (internal * after.displacement) - after.forces * after.displacement;
  const double energy_before =
    0.5 *
      (internal_forces_of(body, before.displacement) * before.displacement) -
    after.forces * before.displacement;

  // What the constraints of the opened rows exert, along the opening that the
  // last split has added; rows that were open before have no part in it.
  LA::Vector wedge = internal;
  wedge -= after.forces;
  double work = 0;
  for (const auto index : body.model->discretization.owned)
    if (after.opening(index) != 0)
      work += wedge(index) * (after.opening(index) - before.opening(index));
  work = Utilities::MPI::sum(work, body.communicator);

  const double scale =
    std::abs(energy_before) + std::abs(energy_after) + std::abs(work);
  if (!(energy_after <= energy_before + work + 1e-8 * scale))
    {
      std::ostringstream message;
      message << "A split has raised the potential energy under the same load "
                 "from "
              << energy_before << " to " << energy_after
              << ", while the blade's thickness did work of " << work
              << " only. The solution is not to be trusted; lower "
                 "Solver/Tolerance or set Solver/Method = direct.";
      throw SolverError(message.str());
    }
}



#define SETSUDAN_INSTANTIATE(dim)                                  \
  template BladeLoad<dim> no_blade(const CutBody<dim> &);          \
  template BladeLoad<dim> blade_on_row(                            \
    const Scene<dim> &, const CutBody<dim> &, const unsigned int); \
  template State<dim> rest_state(const CutBody<dim> &);            \
  template State<dim> solve_state(const Scene<dim> &,              \
                                  CutBody<dim> &,                  \
                                  const BladeLoad<dim> &,          \
                                  const double,                    \
                                  const LA::Vector &);             \
  template State<dim> solve_ramp(const Scene<dim> &,               \
                                 CutBody<dim> &,                   \
                                 const BladeLoad<dim> &,           \
                                 const unsigned int);              \
  template void judge(const Scene<dim> &,                          \
                      const CutBody<dim> &,                        \
                      const unsigned int,                          \
                      State<dim> &);                               \
  template void describe_state(const Scene<dim> &,                 \
                               CutBody<dim> &,                     \
                               const BladeLoad<dim> &,             \
                               const State<dim> &,                 \
                               Event &);                           \
  template void check_energy_of_split(                             \
    CutBody<dim> &, const State<dim> &, const State<dim> &);

SETSUDAN_INSTANTIATE(2)
SETSUDAN_INSTANTIATE(3)

#undef SETSUDAN_INSTANTIATE
} // namespace Setsudan
