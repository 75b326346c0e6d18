// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/supports.h>
#include <setsudan/material/material_parameters.h>
#include <setsudan/mechanics/internal_variables.h>
#include <setsudan/mechanics/loads.h>
#include <setsudan/mechanics/stiffness.h>

#include <memory>

namespace Setsudan
{
template <int dim>
class CellBatches;

/** All of the elastic body that hangs on its mesh, and is made anew when the
 * mesh is cut. */
template <int dim>
struct ElasticModel
{
  /** @param mesh, load_parameters and materials must live as long. */
  ElasticModel(const CoarseMesh<dim> &mesh,
               const Refinement &refinement,
               const Body<dim> &body,
               const Supports<dim> &supports,
               const LoadParameters<dim> &load_parameters,
               const MaterialParameters<dim> &materials,
               const MPI_Comm communicator,
               const ElementType element_type = ElementType::serendipity);

  ~ElasticModel();

  /** The cells for work without a matrix, which is made when it is first asked
   * for; not for linear elements. */
  CellBatches<dim> &
  batches() const;

  /** Whether all laws are linear. */
  bool
  is_linear() const;

  /** Let loads and what supports prescribe be so many times those of the scene.
   */
  void
  set_load_factor(const double factor);

  /** See set_load_factor(). */
  double
  load_factor() const
  {
    return factor_of_loads;
  }

  const MaterialParameters<dim> &materials;
  const LoadParameters<dim> &load_parameters;
  Discretization<dim> discretization;
  /** Evaluating a state sets the trial ones. */
  mutable InternalVariables<dim> internal;
  ElementStiffness<dim> stiffness;
  /** The constraints of hanging nodes, closed; none in a mesh that is refined
   * everywhere alike. */
  dealii::AffineConstraints<double> hanging;
  /** What the supports hold, closed; hanging nodes are left to those between
   * which they hang. */
  dealii::AffineConstraints<double> supports;
  /** The unknowns of this process that a support holds. */
  dealii::IndexSet supported;
  /** A displacement that has what the supports prescribe, and is otherwise
   * zero but at hanging nodes. */
  LA::Vector lift;
  /** Nodal forces of the loads, without the blade; and without pressures under
   * finite strain, which change with the displacement (see FollowerPressure).
   */
  LA::Vector loads;

private:
  void
  constrain_supports(const Supports<dim> &supports_of_body);

  mutable std::unique_ptr<CellBatches<dim>> cell_batches;
  double factor_of_loads = 1;
  /** Those of the scene; empty where the factor has always been 1. */
  LA::Vector loads_of_scene, lift_of_scene;
};

/** What the elements do in a state. */
struct InternalForces
{
  /** F(u), see internal_forces(). */
  LA::Vector forces;
  /** The forces are the derivatives of its potential; where that is infinite
   * they are not set. */
  Energy energy;
  /** That of pressures, see FollowerPressure. */
  double potential_of_pressure = 0;
};

/** Evaluate the laws in a state, of whatever kind they are: of a linear body
 * internal_forces() is faster.
 *
 * @param displacement without ghosts. */
template <int dim>
InternalForces
evaluate_laws(const ElasticModel<dim> &model, const LA::Vector &displacement);

/** The internal forces F(u) by which the elements resist a displacement, K u in
 * a linear body, with no constraint applied; neither has ghosts. Pressures that
 * follow the surface, which change with the displacement as the elements'
 * forces do, are subtracted. */
template <int dim>
LA::Vector
internal_forces(const ElasticModel<dim> &model, const LA::Vector &displacement);

/** Displacements without ghosts for which a tangent is taken; null in a linear
 * body. */
struct Linearization
{
  /** About which it is. */
  const LA::Vector *about = nullptr;
  /** From which its stress is extrapolated, see LawIntegration; null for the
   * exact tangent. */
  const LA::Vector *before = nullptr;
};

/** Assemble the tangent of the internal forces, condensed with `constraints`.
 *
 * @param matrix empty, or from an earlier call with the same constraints. */
template <int dim>
void
assemble_tangent(const ElasticModel<dim> &model,
                 const Linearization &linearization,
                 const dealii::AffineConstraints<double> &constraints,
                 LA::SparseMatrix &matrix);

/** The exact tangent about a displacement times a direction, with no constraint
 * applied; no vector has ghosts. */
template <int dim>
LA::Vector
tangent_times(const ElasticModel<dim> &model,
              const LA::Vector &displacement,
              const LA::Vector &direction);

/** The nodal forces of pressures that follow the surface; no vector has ghosts.
 */
template <int dim>
LA::Vector
follower_forces(const ElasticModel<dim> &model, const LA::Vector &displacement);
} // namespace Setsudan
