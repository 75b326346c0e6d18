#pragma once

#include <setsudan/elasticity/elastic_model.h>
#include <setsudan/elasticity/rigid_modes.h>

#include <vector>

namespace Setsudan
{
/** A piece that its supports do not hold, and what would hold it. */
struct LoosePiece
{
  unsigned int piece;
  /** Vertices of the mesh and components to hold, one per rigid motion. */
  std::vector<PointComponent> hold;
};

/** @param pieces the piece of every element (see find_pieces()). */
template <int dim>
std::vector<LoosePiece>
find_loose_pieces(const CoarseMesh<dim> &mesh,
                  const std::vector<unsigned int> &pieces,
                  const Supports<dim> &supports);

/**
 * Check that the loads on a loose piece are in equilibrium, so that holding it
 * at a few points puts no force into it.
 *
 * @throw std::runtime_error where they are not: then nothing keeps the piece.
 */
template <int dim>
void
check_loads_on_loose_piece(const ElasticModel<dim> &model,
                           const std::vector<unsigned int> &pieces,
                           const LoosePiece &loose);

/** Constrain the unknowns that hold a loose piece. */
template <int dim>
void
constrain_loose_piece(const Discretization<dim> &discretization,
                      const CoarseMesh<dim> &mesh,
                      const std::vector<unsigned int> &pieces,
                      const LoosePiece &loose,
                      dealii::AffineConstraints<double> &constraints);

/** Constrain all unknowns of a piece that is left out: it stays at rest. */
template <int dim>
void
constrain_dropped_piece(const Discretization<dim> &discretization,
                        const std::vector<unsigned int> &pieces,
                        const LoosePiece &loose,
                        dealii::AffineConstraints<double> &constraints);

/** Take the loads and prescribed displacements off a piece that is left out. */
template <int dim>
void
remove_loads_from_piece(const std::vector<unsigned int> &pieces,
                        const LoosePiece &loose,
                        ElasticModel<dim> &model);
} // namespace Setsudan
