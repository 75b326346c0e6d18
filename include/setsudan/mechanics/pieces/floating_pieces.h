// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/space/rigid_modes.h>

#include <vector>

namespace Setsudan
{
/**
 * A floating piece: one with at least one unconstrained rigid-body mode, and
 * the constraints that would stop all of them.
 */
struct FloatingPiece
{
  unsigned int piece;
  /** Vertices of the mesh and components to hold, one per rigid motion. Empty
   * for a piece that others hold once they are held themselves. */
  std::vector<PointComponent> hold;

  bool
  operator==(const FloatingPiece &other) const
  {
    return piece == other.piece && hold == other.hold;
  }
};

/** The unknowns that hold loose pieces, the same on all processes.
 *
 * @param pieces the piece of every element (see find_pieces()). */
template <int dim>
std::vector<dealii::types::global_dof_index>
unknowns_of_hold(const Discretization<dim> &discretization,
                 const CoarseMesh<dim> &mesh,
                 const std::vector<unsigned int> &pieces,
                 const std::vector<FloatingPiece> &loose);

/** Constrain all unknowns of a piece that is left out: it stays at rest. */
template <int dim>
void
constrain_dropped_piece(const Discretization<dim> &discretization,
                        const std::vector<unsigned int> &pieces,
                        const FloatingPiece &loose,
                        dealii::AffineConstraints<double> &constraints);

/** Take the loads and prescribed displacements off a piece that is left out. */
template <int dim>
void
remove_loads_from_piece(const std::vector<unsigned int> &pieces,
                        const FloatingPiece &loose,
                        ElasticModel<dim> &model);
} // namespace Setsudan
