// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/cut/seam/seam.h>
#include <setsudan/mechanics/pieces/piece_motions.h>

#include <functional>
#include <memory>
#include <vector>

namespace Setsudan
{
/** The parts into which a body falls as a cut goes on, and what becomes of
 * those that float, since no support holds them any more: they are held at as
 * few components as stop their rigid motions, or dropped. */
template <int dim>
class SeveredParts
{
public:
  /** @param parts of the uncut mesh: the part of every element.
   * @param drops whether floating parts are dropped, and not held. */
  SeveredParts(const std::vector<unsigned int> &parts, const bool drops);

  /** Take the mesh behind a surgery, and the parts it will have when the cut
   * has gone through.
   *
   * @param on_board the faces that a board carries. */
  void
  set_mesh(const CoarseMesh<dim> &mesh,
           const std::vector<unsigned int> &parts,
           const Supports<dim> &supports,
           const std::vector<CellFace> &on_board);

  const std::vector<unsigned int> &
  parts() const;

  /** Whether no part can float. */
  bool
  all_held() const;

  const std::vector<FloatingPiece> &
  floating() const;

  /** How many would float in other states of the seam's pairs. */
  std::size_t
  n_floating(const Seam<dim> &seam, const PairStates &states) const;

  /**
   * Find the parts that float now. Those that are dropped are left out of the
   * seam, and their loads taken off.
   *
   * @param states    of the seam's pairs, as a function of it.
   * @param direction of the blade.
   * @return whether other parts float than before.
   * @throw FloatingPieceError where the loads on a part to be held, or the
   *   blade on ties to it, would move it.
   */
  bool
  update(const std::function<PairStates()> &states,
         const dealii::Tensor<1, dim> &direction,
         Seam<dim> &seam,
         ElasticModel<dim> &model);

  /** Take the loads off what has been dropped. */
  void
  remove_loads(ElasticModel<dim> &model) const;

  /** Constrain what holds floating parts, or all of those that are dropped.
   * Called by all processes. */
  void
  add_constraints(const Discretization<dim> &discretization,
                  const CoarseMesh<dim> &mesh,
                  dealii::AffineConstraints<double> &constraints) const;

  const bool drops;

private:
  std::vector<unsigned int> part_of_element;
  std::unique_ptr<PieceMotions<dim>> motions;
  std::vector<FloatingPiece> floating_parts;
};
} // namespace Setsudan
