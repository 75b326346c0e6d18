#pragma once

#include <deal.II/lac/vector.h>

#include <setsudan/mechanics/balance.h>
#include <setsudan/simulation/cut_body.h>
#include <setsudan/solver/assembled_solver.h>

#include <optional>
#include <vector>

namespace Setsudan
{
/** The blade on a row: its nodal forces at load factor 1, and the forces where
 * the scene puts them. */
template <int dim>
struct BladeLoad
{
  LA::Vector nodal_forces;
  std::vector<PointForce<dim>> forces;
  /** The row of the newest cut on which it stands. */
  std::optional<unsigned int> row;
};

/** No blade: all forces zero. */
template <int dim>
BladeLoad<dim>
no_blade(const CutBody<dim> &body);

/** The blade on the front of a row of the newest cut. */
template <int dim>
BladeLoad<dim>
blade_on_row(const CutBody<dim> &body, const unsigned int row);

/** A solved state of the body. */
template <int dim>
struct State
{
  /** Without ghosts. */
  LA::Vector displacement;
  /** The part of it that the blade's thickness prescribes. */
  LA::Vector opening;
  /** All nodal forces. */
  LA::Vector forces;
  /** K u, with which the elements resist (see internal_forces()). */
  LA::Vector internal;
  double load_factor = 0;
  SolveQuality quality;
  CuttingStress stress;
  /** Whether the front row yields; set where it is asked for. */
  bool yields = false;
  /** The error of each cell, where it is estimated (see ErrorEstimate). */
  dealii::Vector<double> error_squares = {};
};

/** What the supports and the opening of the cut prescribe. */
template <int dim>
LA::Vector
prescribed_displacement(const CutBody<dim> &body, const State<dim> &state);

/** The undeformed body, on the present mesh. */
template <int dim>
State<dim>
rest_state(const CutBody<dim> &body);

/** A state under the body's loads and `load_factor` times the blade that has
 * not been solved for. */
template <int dim>
State<dim>
loaded_state(const Scene<dim> &scene,
             const CutBody<dim> &body,
             const BladeLoad<dim> &blade,
             const double load_factor);

/** The state of the body under its loads and `load_factor` times the blade,
 * from the displacement that has been solved for. */
template <int dim>
State<dim>
make_state(const Scene<dim> &scene,
           CutBody<dim> &body,
           const BladeLoad<dim> &blade,
           const double load_factor,
           const LA::Vector &displacement);

/** How much of the forces is not in equilibrium with K u under the body's
 * present constraints, relative to all nodal forces of the elements. */
template <int dim>
double
unbalanced_part(const CutBody<dim> &body,
                const BladeLoad<dim> &blade,
                const State<dim> &state);

/**
 * Solve for the body under its loads and `load_factor` times the blade.
 *
 * @param guess a displacement near the solution.
 */
template <int dim>
State<dim>
solve_state(const Scene<dim> &scene,
            CutBody<dim> &body,
            const BladeLoad<dim> &blade,
            const double load_factor,
            const LA::Vector &guess);

} // namespace Setsudan
