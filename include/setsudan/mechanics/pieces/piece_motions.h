// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/pieces/floating_pieces.h>

#include <array>
#include <map>
#include <vector>

namespace Setsudan
{
/** Two pieces that move alike at a point, along one direction. */
template <int dim>
struct PieceLink
{
  std::array<unsigned int, 2> pieces;
  dealii::Point<dim> position;
  dealii::Tensor<1, dim> direction;
};

/** A group of linked pieces with at least one unconstrained rigid-body mode. */
template <int dim>
struct FloatingGroup
{
  /** All pieces of the group; its bodies are in this order. */
  std::vector<unsigned int> pieces;
  /** By supports and links, without what would hold the rest. */
  RigidBodyConstraints<dim> held;
  /** Those of the pieces that can move. */
  std::vector<FloatingPiece> loose;
};

/**
 * How the pieces of a body can move as rigid bodies. The links between them,
 * which a cut reduces row by row, are given each time; what the supports hold
 * is found once.
 */
template <int dim>
class PieceMotions
{
public:
  /** @param pieces the piece of every element (see find_pieces()).
   * @param on_board faces that a board carries: whatever they belong to is
   *   held. */
  PieceMotions(const CoarseMesh<dim> &mesh,
               const std::vector<unsigned int> &pieces,
               const Supports<dim> &supports,
               const std::vector<CellFace> &on_board = {});

  /** Whether every piece is held by supports of its own, so that links do not
   * matter. */
  bool
  all_held() const;

  std::vector<FloatingGroup<dim>>
  find_floating(const std::vector<PieceLink<dim>> &links) const;

private:
  struct Piece
  {
    std::vector<unsigned int> vertices;
    std::vector<dealii::Point<dim>> positions;
    std::vector<HeldPoint<dim>> supports;
  };

  FloatingGroup<dim>
  make_group(const std::vector<unsigned int> &numbers,
             const std::vector<const PieceLink<dim> *> &links) const;

  /** By number, those that their own supports do not hold. */
  std::map<unsigned int, Piece> unheld;
};

/**
 * Check that the loads do no work in the motions of a loose group, so that
 * holding its pieces at a few points puts no force into them.
 *
 * @throw FloatingPieceError where they do: then nothing keeps the pieces.
 */
template <int dim>
void
check_loads_on_loose_group(const ElasticModel<dim> &model,
                           const std::vector<unsigned int> &pieces,
                           const FloatingGroup<dim> &group);
} // namespace Setsudan
