// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/cut/seam/opening_force.h>
#include <setsudan/mechanics/balance.h>
#include <setsudan/mechanics/stress/deformation_extremes.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/simulation/checks.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The magnitudes of a vector's components, of this process. */
double
sum_of_magnitudes(const LA::Vector &vector)
{
  double sum = 0;
  for (const double component : vector)
    sum += std::abs(component);
  return sum;
}

/** The forces of the blade that keeps pairs open, on their nodes. */
template <int dim>
LA::Vector
forces_of_wedge(const CutBody<dim> &body, const State<dim> &state)
{
  LA::Vector forces = body.model().discretization.zero_vector();
  if (state.blade.presses())
    return state.blade.pressure;
  if (!body.has_cut())
    return forces;
  const auto states = body.pair_states();
  for (unsigned int p = 0; p < body.seam().pairs().size(); ++p)
    if (states[p] == PairState::opened)
      for (const auto *side :
           {&body.seam().pairs()[p].minus, &body.seam().pairs()[p].plus})
        for (const auto index : *side)
          if (body.model().discretization.owned.is_element(index))
            forces(index) = state.internal(index) - state.forces(index);
  forces.compress(VectorOperation::insert);
  return forces;
}

/** The magnitudes, on this process, of K times what is prescribed; 0 in a body
 * that is not linear. */
template <int dim>
double
resistance(const CutBody<dim> &body, const State<dim> &state)
{
  return body.model().is_linear() ? sum_of_magnitudes(internal_forces(
                                      body.model(), lift_of(body, state)))
                                  : 0;
}

/** The balance of a state.
 *
 * @param blade the blade's forces.
 * @throw InvariantError where forces or moments do not cancel. */
template <int dim>
BodyBalance<dim>
checked_balance(const CutBody<dim> &body,
                const State<dim> &state,
                const std::vector<PointForce<dim>> &blade)
{
  // A solve that leaves more to round-off is accepted, and warned of.
  const double tolerance = std::max(
    {1e-8, 100 * body.scene().solver.tolerance, 10 * state.quality.residual});
  const auto is_balanced = [&](const Balance &balance) {
    return balance.force_residual <= tolerance &&
           balance.moment_residual <= tolerance;
  };
  const LA::Vector of_wedge = forces_of_wedge(body, state);
  const double wedge        = sum_of_magnitudes(of_wedge);
  const bool is_finite      = body.model().materials.finite_strain;
  // As far as the blade ties the nodes that it keeps apart along its flanks, it
  // exerts moments about them.
  LA::Vector applied = all_forces(state);
  if (is_finite && !state.blade.presses())
    applied += of_wedge;
  const auto balanced_beside = [&](const double cancelling) {
    return check_balance(body.model(),
                         state.internal,
                         applied,
                         blade,
                         cancelling,
                         is_finite ? &state.displacement : nullptr);
  };
  auto balance = balanced_beside(wedge);
  if (!is_balanced(balance))
    balance = balanced_beside(wedge + state.quality.force_scale +
                              resistance(body, state));
  if (!is_balanced(balance))
    {
      std::ostringstream message;
      message << "The forces on the body are not in balance: the relative "
                 "residuals of force and moment are "
              << balance.force_residual << " and " << balance.moment_residual
              << " and must not exceed " << tolerance
              << (state.board
                    ? ". The body, or a piece of it, does not stay on "
                      "the board: loads or blade lift it off, tip it "
                      "over or push it aside where nothing but the "
                      "board holds it. Hold it in subsection Support, "
                      "or change Board/Plane. If it does stay, lower"
                    : ". Lower")
              << " Solver/Tolerance or set Solver/Method = direct; if "
                 "that does not help, round-off has taken the digits, since "
                 "the body is too slender or its stiffness too uneven.";
      throw InvariantError(message.str());
    }
  return balance;
}
} // namespace



template <int dim>
WallOverlap<dim>
evaluate_state(const CutBody<dim> &body, const State<dim> &state, Event &event)
{
  event.load_factor    = state.blade.row ? state.load_factor : 0;
  event.cutting_stress = state.stress.reached;
  // A state that is not judged leaves what was required before.
  if (state.stress.required > 0)
    event.required_stress = state.stress.required;
  event.pieces                        = body.n_pieces();
  event.blade_force                   = 0;
  std::vector<PointForce<dim>> forces = state.blade.forces;
  for (auto &force : forces)
    {
      force.force *= state.load_factor;
      event.blade_force += force.force * body.cut().edge.direction;
    }
  if (state.motion)
    {
      const BladeMotion before = event.motion.value_or(BladeMotion());
      const double moved       = state.motion->travel - before.travel;
      if (moved != 0)
        event.mean_force = (state.motion->work - before.work) / moved;
      event.motion = state.motion;
      // The body does not feel all of it where it presses across the cut only.
      event.blade_force = state.motion->edge_force + state.motion->flank_force;
    }
  event.strain_energy    = state.strain_energy;
  event.potential_energy = state.potential_energy;
  if (event.plastic_energy)
    event.plastic_energy = state.plastic_energy;
  if (event.viscous_energy)
    event.viscous_energy = state.viscous_energy;

  const auto extremes    = find_extremes(body.model(), state.displacement);
  event.min_jacobian     = extremes.min_jacobian;
  event.max_strain       = extremes.max_strain;
  event.max_shear        = extremes.max_shear;
  event.max_displacement = extremes.max_displacement;

  if (state.board)
    {
      forces.insert(
        forces.end(), state.board->forces.begin(), state.board->forces.end());
      event.board_force = state.board->force;
    }
  const auto balance    = checked_balance(body, state, forces);
  event.force_residual  = balance.force_residual;
  event.moment_residual = balance.moment_residual;
  for (unsigned int d = 0; d < dim; ++d)
    {
      event.reaction[d]    = balance.reaction[d];
      event.clamp_force[d] = balance.clamp_force[d];
    }
  if (state.blade.presses())
    {
      event.opening_force = state.blade.opening_force;
      event.opening_pull  = 0;
    }
  else if (body.has_cut())
    {
      LA::Vector exerted = state.internal;
      exerted -= state.forces;
      const auto opening =
        opening_force(body.seam(), body.pair_states(), exerted);
      event.opening_force = opening.total;
      event.opening_pull  = opening.pull;
    }
  const auto overlap =
    find_wall_overlap(body.walls(), state.displacement, body.communicator());
  // Newton's method ends before round-off, and walls that touch overlap by what
  // it leaves.
  const double left =
    body.model().is_linear() ? 0 : 1e-8 * body.scene().body.mesh.extent();
  event.overlap = overlap.depth > left ? overlap.depth : 0;
  return overlap;
}



template <int dim>
void
check_energy_of_split(const CutBody<dim> &body,
                      const State<dim> &before,
                      const State<dim> &after)
{
  // In a body that is not linear the work of an opening has no bound by its
  // last forces, and pressures that follow have no potential where the rim of
  // their surface is free.
  // Nor do forces of a blade that has moved bound its work where a body
  // remembers.
  if (!body.model().is_linear() &&
      ((after.blade.presses() && !body.model().internal.empty()) ||
       after.opening.linfty_norm() > 0 || after.pressure_energy != 0))
    return;
  // Plastic flow is no loss here: a body takes the least of what it stores and
  // what flow takes, from the last state on.
  const auto energy_of = [&](const State<dim> &state) {
    return state.strain_energy + state.plastic_energy + state.viscous_energy +
           state.pressure_energy - after.forces * state.displacement;
  };
  const double energy_after  = energy_of(after);
  const double energy_before = energy_of(before);

  // What the constraints of the opened rows exert, along the opening that the
  // last split has added; rows that were open before have no part in it.
  LA::Vector wedge = after.internal;
  wedge -= after.forces;
  double work = 0;
  for (const auto index : body.model().discretization.owned)
    if (after.opening(index) != 0)
      work += wedge(index) * (after.opening(index) - before.opening(index));
  // By convexity: pressure that has opened further than before it was there.
  if (after.blade.presses())
    for (const auto index : body.model().discretization.owned)
      work += after.blade.pressure(index) *
              (after.displacement(index) - before.displacement(index));
  work = Utilities::MPI::sum(work, body.communicator());

  double scale =
    std::abs(energy_before) + std::abs(energy_after) + std::abs(work);
  // Where nothing strains the body these are round-off of what it could take.
  const auto holds = [&] {
    return energy_after <= energy_before + work + 1e-8 * scale;
  };
  if (!holds())
    scale += after.displacement.linfty_norm() *
             Utilities::MPI::sum(resistance(body, after), body.communicator());
  if (!holds())
    {
      std::ostringstream message;
      message << "A split has raised the potential energy under the same load "
                 "from "
              << energy_before << " to " << energy_after
              << ", while the blade's thickness did work of " << work
              << " only. The solution is not to be trusted; lower "
                 "Solver/Tolerance or set Solver/Method = direct.";
      throw InvariantError(message.str());
    }
}



template WallOverlap<2>
evaluate_state(const CutBody<2> &, const State<2> &, Event &);
template void
check_energy_of_split(const CutBody<2> &, const State<2> &, const State<2> &);
template WallOverlap<3>
evaluate_state(const CutBody<3> &, const State<3> &, Event &);
template void
check_energy_of_split(const CutBody<3> &, const State<3> &, const State<3> &);
} // namespace Setsudan
