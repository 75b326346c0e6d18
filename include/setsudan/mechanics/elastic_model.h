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
  /** @param mesh and materials must live as long. */
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

  const MaterialParameters<dim> &materials;
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
  /** Nodal forces of the loads, without the blade. */
  LA::Vector loads;

private:
  void
  constrain_supports(const Supports<dim> &supports_of_body);

  mutable std::unique_ptr<CellBatches<dim>> cell_batches;
};

/** The internal forces F(u) by which the elements resist a displacement, K u in
 * a linear body, with no constraint applied; neither has ghosts. */
template <int dim>
LA::Vector
internal_forces(const ElasticModel<dim> &model, const LA::Vector &displacement);

/** Assemble the tangent of the internal forces, condensed with `constraints`.
 *
 * @param displacement about which it is, without ghosts; null in a linear body.
 */
template <int dim>
void
assemble_tangent(const ElasticModel<dim> &model,
                 const LA::Vector *displacement,
                 const dealii::AffineConstraints<double> &constraints,
                 LA::SparseMatrix &matrix);

/** The energy that a displacement stores.
 *
 * @param internal its internal forces. */
template <int dim>
double
stored_energy(const ElasticModel<dim> &model,
              const LA::Vector &displacement,
              const LA::Vector &internal);
} // namespace Setsudan
