// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/contact/complementarity.h>
#include <setsudan/contact/contact_basis.h>

#include <array>

namespace Setsudan
{
/**
 * A condition of contact at the travel p: vectors of a basis, and what they
 * must not fall below, as far as the displacement is concerned. Its multiplier
 * is a pressure or a force.
 *
 *   edge on a node of the front  d.u - (p - z) >= 0
 *   flank on a hat of a wall     o.u + t d.u - A (h + t (p - z - s)) >= 0
 *   flank on a hat of an outer face
 *                                o.u + t d.u - A (h + t (p - z - s) - x) >= 0
 *   wall on wall                 o.u- + o.u+ >= 0
 *
 *   body on the board         n.u + A g >= 0
 *
 * where d.u is the displacement along the blade's direction and o.u that out of
 * the cut, both weighted with the hat, A the hat's integral and z its depth,
 * and the facet begins s behind the edge with half thickness h and slope t. An
 * outer face at the entry is at the mean distance x from the cut's plane, and
 * meets the flank as the wall on its side does, before the first row splits
 * too.
 *
 * A blade that presses across the cut only has d.u left out of the flanks'
 * conditions, and their pressure exerts (1, mu). Its force is the same, t + mu:
 * what it does against the slope t the body does not feel.
 *
 * A blade that is not guided shifts by x, one unknown, which the flanks'
 * conditions of the minus side have with the factor +A and those of the plus
 * side with -A; the forces of both sides across the cut cancel.
 *
 * While the blade is pushed its flanks slip, and friction acts in a known
 * direction: a pressure exerts (1 - mu t) out of the cut and t + mu along the
 * direction, so that the problem is not symmetric. A blade that slices moves xi
 * aside for each length that it is pushed: its edge drags the front along its
 * way, by k = xi or as far as it grips, and friction acts along it too:
 *
 *   edge  d.u + k e.u - (1 + k^2) (p - z) >= 0
 *   flank exerts  1 - m t out, t + m along, m xi (1 + t^2)^1/2 aside, where
 *         m = mu / (1 + xi^2)^1/2.
 *
 * Where the blade turns, the walls begin by sticking to it: a hat that sticks
 * keeps its place along the flank,
 *
 *   stick on a hat of a wall     d.u - t o.u = A p + anchor,
 *
 * with a multiplier theta that exerts the same, as long as |theta| is not more
 * than mu times the pressure, and what adhesion adds. Beyond that it slips, one
 * way or the other, until the blade does not slip that way along it. All of
 * these changes are breakpoints, too. Adhesion is a traction of its own on hats
 * from when they come to touch until they come apart.
 *
 * Where forces on the edge press a blade in that has a thickness T and no
 * flanks, they rise with the parameter p, and the blade keeps the walls apart:
 *
 *   walls  o.u- + o.u+ >= A' T,
 *
 * A' being the part of A that belongs to nodes which are split: up to the
 * front, which is tied, the blade's thickness falls to nothing within an
 * element.
 *
 * Where the body is not linear what rests on a sharp edge does not slide off
 * it:
 *
 *   hold  n.u = 0 where the edge presses, n normal to the cut.
 *
 * On the board, at the distance g, a corner sticks where it has come to it: two
 * grips, in 2D one, follow its condition.
 */
template <int dim>
struct ContactCondition
{
  using Wall = typename ContactBasis<dim>::Wall;

  enum class Kind
  {
    edge,
    hold,
    flank,
    stick,
    walls,
    board,
    grip
  };

  Kind kind = Kind::walls;
  /** The hat or node of the edge. */
  unsigned int place = 0;
  Wall wall          = Wall::minus;
  /** Vectors of the basis and their factors: what it measures, and what its
   * multiplier exerts. */
  VectorSum measured;
  VectorSum exerted;
  double constant   = 0;
  double per_travel = 0;
  /** What a multiplier of 1 asks of the blade along its direction, the part
   * of it that the body does not feel and that which is friction, and what it
   * exerts aside. */
  double force    = 0;
  double unfelt   = 0;
  double friction = 0;
  double aside    = 0;
  /** The energy that it takes over a slip of 1 along and aside. */
  std::array<double, 2> dissipation{};
  /** What a shift of the blade adds to the gap. */
  double across = 0;
  /** By which a gap between walls is its mean. */
  double area = 0;
  /** The number of the direction along a board. */
  unsigned int direction = 0;
  /** The stiffness of the foundation's spring. */
  double spring = 0;

  bool
  is_same(const ContactCondition &other) const;

  /** Whether it is one of a flank, on a wall. */
  bool
  is_of_flank() const
  {
    return kind == Kind::flank || kind == Kind::stick;
  }
};
} // namespace Setsudan
