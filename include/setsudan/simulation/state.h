// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/vector.h>

#include <setsudan/blade/blade_motion.h>
#include <setsudan/simulation/cut_body.h>

#include <optional>

namespace Setsudan
{
/** A state of the body; no vector has ghosts. */
template <int dim>
struct State
{
  /** The blade, which acts times the load factor. */
  BladeLoad<dim> blade;
  double load_factor = 0;
  /** What the board does. */
  std::optional<BoardLoad<dim>> board;
  LA::Vector displacement;
  /** The part of it that the blade's thickness prescribes. */
  LA::Vector opening;
  /** All external nodal forces but the blade's pressure, which is not given but
   * found, as the forces of constraints are. */
  LA::Vector forces;
  /** The internal forces, see Solution. */
  LA::Vector internal;
  /** Elastic energy, that of pressures which follow the surface, and the sum of
   * both minus the work of all forces but the board's as dead loads. */
  double strain_energy    = 0;
  double pressure_energy  = 0;
  double potential_energy = 0;
  /** What plastic flow has taken since the run began, and viscosity. */
  double plastic_energy = 0;
  double viscous_energy = 0;
  SolveQuality quality;
  CuttingStress stress;
  /** Of a blade that travels. */
  std::optional<BladeMotion> motion;
  /** Whether the front row yields; set where it is asked for. */
  bool yields = false;
  /** The square of the error's energy norm in each cell, where it is estimated
   * (see ErrorEstimate). */
  dealii::Vector<double> error_squares = {};
};

/** The undeformed body, on the present mesh. */
template <int dim>
State<dim>
rest_state(const CutBody<dim> &body);

/** A state under the body's loads and `load_factor` times the blade that has
 * not been solved for. */
template <int dim>
State<dim>
loaded_state(const CutBody<dim> &body,
             const BladeLoad<dim> &blade,
             const double load_factor,
             const std::optional<BoardLoad<dim>> &board = {});

/** What supports and opening prescribe in a state. */
template <int dim>
LA::Vector
lift_of(const CutBody<dim> &body, const State<dim> &state);

/** The external nodal forces, and the blade's pressure. */
template <int dim>
LA::Vector
all_forces(const State<dim> &state);

/** Put a solution into a loaded state. */
template <int dim>
void
set_solution(const ElasticModel<dim> &model,
             Solution &&solution,
             State<dim> &state);

/**
 * Solve for the body under its loads and `load_factor` times the blade.
 *
 * @param guess a displacement near the solution.
 * @param board what the board does, if the body lies on one.
 */
template <int dim>
State<dim>
solve_state(CutBody<dim> &body,
            const BladeLoad<dim> &blade,
            const double load_factor,
            const LA::Vector &guess,
            const std::optional<BoardLoad<dim>> &board = {});

/** The potential energy of a body under its loads without the forces of
 * contact. */
template <int dim>
double
energy_under_loads(const State<dim> &state);

/** How much of the forces is not in equilibrium with the internal ones under
 * the body's present constraints, relative to the internal forces. */
template <int dim>
double
unbalanced_part(const CutBody<dim> &body, const State<dim> &state);
} // namespace Setsudan
