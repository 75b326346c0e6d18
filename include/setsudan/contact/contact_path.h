// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/blade/blade_motion.h>
#include <setsudan/blade/blade_profile.h>
#include <setsudan/contact/complementarity.h>
#include <setsudan/contact/contact_basis.h>
#include <setsudan/contact/contact_condition.h>
#include <setsudan/contact/contact_resultants.h>
#include <setsudan/contact/contact_stage.h>
#include <setsudan/contact/quadratic.h>

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace Setsudan
{
/**
 * The equilibrium of a body with its blade, while the first rows of the cut are
 * split and the blade travels: unilateral contact of the two walls with the
 * blade's flanks and with each other, and of the front with the edge.
 *
 * Between breakpoints, where contacts open or close or a wall passes from one
 * facet of the blade to the next, all is linear in the travel p, and the energy
 * quadratic: see ContactCondition.
 */
template <int dim>
class ContactPath
{
public:
  using Wall = typename ContactBasis<dim>::Wall;

  /**
   * @param profile must live as long, and the basis of the stage.
   * @param smallest_step of the parameter: a travel that is small beside a row.
   */
  ContactPath(std::unique_ptr<const ContactStage<dim>> stage,
              const BladeProfile &profile,
              const SlidingBlade &sliding,
              const double smallest_step);

  /** Find the contacts where the blade is, beginning with those of another
   * stage.
   *
   * @param measured what the vectors measure where the corners on a board
   *   stick, if there is no other stage; empty for that of the body at rest. */
  void
  begin(const BladeMotion &motion,
        const ContactPath *neighbour,
        const std::vector<double> &measured = {});

  /** Follow smaller travels from here on, or larger ones again.
   *
   * @param heading 1 for larger ones, -1 for smaller ones.
   * @return the energy that is lost, where adhesion turns round on walls that
   *   do not touch. */
  double
  head(const int heading, const double travel);

  /** Up to where the present contacts hold on the blade's way; infinite where
   * nothing ends them. */
  double
  end() const
  {
    return end_of_piece;
  }

  /** Go on to the contacts beyond end().
   *
   * @return the energy that is lost: it is not 0 where a wall springs back at
   *   an edge between facets, or where with friction the equilibrium ends. */
  double
  cross_end();

  /** The potential energy of the body under its loads, up to what is the same
   * in all stages of a cut, over the travel or factor. */
  Quadratic
  energy() const;

  /** Those of the contacts that hold now, over the travel. */
  ContactResultants
  resultants() const;

  /** The energy that friction takes from one travel to another, with the
   * contacts that hold now. */
  double
  friction_work(const double begin, const double end) const;

  /** That while rows split and the contact of another stage follows, over the
   * travel at which they do: with the mean of the pressures before and after.
   */
  Quadratic
  friction_work_to(const ContactPath &after) const;

  /** That on a step from one travel to another, at which the contact is another
   * one of the same stage: with the mean of the pressures at both ends. */
  double
  friction_work_to(const ContactPath &after,
                   const double begin,
                   const double end) const;

  /** What is left of the energy for new surface, and for an excess. */
  Quadratic
  energy_set_free(const ContactPath &after) const;

  /** How far the blade has shifted towards the plus side. */
  double
  shift(const double travel) const;

  /** The contacts that hold now. */
  BladeContacts
  contacts() const
  {
    return {facets,
            piece.active,
            resting_shift,
            heading,
            has_turned ? slips : std::vector<WallSlip>(),
            adhering,
            state_of_anchors()};
  }

  /** The area on which the flanks press. */
  double
  contact_area() const;

  /** The forces of contact on the vectors of the basis. */
  std::vector<double>
  forces(const double travel) const;

  /** How far conditions of walls are violated: by how much a gap is too small,
   * in the mean over its hat, and the largest pull in relation to the largest
   * pressure.
   *
   * @param measured what the vectors of the basis measure of the body. */
  std::array<double, 2>
  violation(const std::vector<double> &measured, const double travel) const;

  /** Whether the body is stable while the active conditions hold: whether its
   * stiffness is positive on all motions that leave their gaps closed. So it is
   * where the compliance of these has as many negative eigenvalues as the
   * stiffness, and one more for each spring that is taken out.
   *
   * @param n_negative eigenvalues of the stiffness with all springs. */
  bool
  is_stable(const unsigned int n_negative) const;

  /** What the multipliers would do along the gaps by which a displacement
   * violates their conditions: at least as much does the energy of the body
   * rise on the way to one that does not.
   *
   * @param measured what the vectors of the basis measure of it. */
  double
  work_to_fulfil(const std::vector<double> &measured,
                 const double travel) const;

  /** The same of the foundation's springs. */
  std::vector<double>
  foundation_forces(const double travel) const;

private:
  using Condition = ContactCondition<dim>;
  using Kind      = typename Condition::Kind;

  /** The slope of a wall's facet, as far as pressure acts normally to it. */
  double
  tilt(const unsigned int hat, const Wall wall) const;

  Condition
  flank_condition(const unsigned int hat, const Wall wall) const;
  Condition
  stick_condition(const unsigned int hat, const Wall wall) const;
  Condition
  walls_condition(const unsigned int hat) const;
  Condition
  earlier_walls_condition(const unsigned int corner) const;
  Condition
  edge_condition(const unsigned int node) const;
  Condition
  hold_condition(const unsigned int node) const;
  Condition
  board_condition(const unsigned int corner) const;
  Condition
  grip_condition(const unsigned int corner, const unsigned int direction) const;

  /** Add those of corners on the board. */
  void
  add_board_conditions();

  /** The foundation of the conditions; nothing where none has a spring. */
  std::optional<Foundation>
  make_foundation() const;

  /** The leaders of the conditions; empty where none follows. */
  std::vector<unsigned int>
  make_leaders() const;

  /** What the vectors along the board measure at a corner. */
  std::array<double, dim - 1>
  place_on_board(const unsigned int corner, const double travel) const;

  /** Where the corners stick as a list of numbers, to go on from. */
  std::vector<double>
  state_of_anchors() const;

  /** Let the corners stick where those of an earlier path did, or where vectors
   * are measured. */
  void
  begin_anchors(const std::vector<double> &measured,
                const std::vector<double> &earlier);

  /** Let the edge hold the nodes that have come to rest on it; whether there
   * are any. */
  bool
  update_holds();

  /** Let corners stick where they have come to the board; whether any did. One
   * that is torn off again where it sticks has no friction for now. */
  bool
  update_grips(const double travel);

  /** The conditions along the board at the corner of one, begin and end. */
  std::pair<unsigned int, unsigned int>
  grips_of(const unsigned int board_condition) const;

  /** Make the conditions for the facets as they are. */
  void
  make_conditions();

  /** What adheres, and how that moves the vectors. */
  void
  make_adhesion();

  /** And the problem that they pose. */
  void
  make_problem();

  /** The same, with the active set of those before as a guess. */
  void
  remake_conditions();

  /** Take the facets and the active set that hold at a travel. */
  void
  settle(const double travel);

  /** Let a condition become active, or no longer. */
  void
  change_condition(const unsigned int condition,
                   const double travel,
                   const double beyond);

  /** How far a wall at a hat is behind the edge, over the travel. */
  std::array<double, 2>
  distance_behind_edge(const unsigned int hat, const Wall wall) const;

  /** What the gap of a condition requires beyond what the body measures
   * without contact, as constant and slope. */
  std::array<double, 2>
  required_by(const Condition &condition) const;

  /** Whether the walls at a hat may meet ahead of the edge. */
  bool
  may_meet(const unsigned int hat) const;

  /** Whether no other condition changes with the facet of one. */
  bool
  changes_alone(const unsigned int flank) const;

  /** Change the conditions of flanks to their hats' facets. */
  void
  take_facets(const std::vector<unsigned int> &flanks);

  /** Move hats to the facets that they are on; the flanks' conditions of those
   * that did.
   *
   * @param tolerance how far beyond the end of one they may stay on it.
   * @param back whether they may move forward again, while they do not touch.
   */
  std::vector<unsigned int>
  update_facets(const double travel, const double tolerance, const bool back);

  /** Take a piece that holds at a travel, which one process finds. */
  void
  take_piece(const double travel,
             const std::function<Complementarity::Piece()> &solution);

  /** Ask where the facets of the hats, or the friction of those that stick, end
   * the piece. */
  void
  find_end_of_facets(const double travel);
  void
  find_end_of_sticking(const double travel);

  /** Whether a wall stays on its facet until it slips. */
  bool
  keeps_facet(const Condition &flank) const;

  /** Let the walls that touch stick where they are. */
  void
  hold_walls(const double travel);

  /** Let walls slip whose friction is too large, and stick that slip the other
   * way; whether any did.
   *
   * @param one whether only one of them may change. */
  bool
  update_slips(const double travel, const bool one);

  /** The walls that touch, and whether each does. */
  std::vector<bool>
  touching() const;

  /** Let walls adhere that touch now and did not, and no longer those that did
   * and do not. What that itself opens and closes changes no more: with
   * adhesion there need not be a state in which just those adhere that touch.
   *
   * @param touched the walls that did. */
  void
  update_adhesion(const std::vector<bool> &touched, const double travel);

  /** What one must become, if it is to change. */
  std::optional<int>
  other_way(const unsigned int condition,
            const double travel,
            const double largest) const;

  /** The largest friction of a condition of a flank, over the travel. */
  std::array<double, 2>
  largest_friction(const unsigned int condition) const;

  /** Whether anything lets a wall move along a flank. */
  bool
  can_stick(const Condition &flank) const;

  void
  stick(const unsigned int hat, const Wall wall, const double travel);

  /** Whether one travel comes before another one. */
  bool
  is_before(const double travel, const double other) const
  {
    return heading * (other - travel) > 0;
  }

  static unsigned int
  place_of_wall(const unsigned int hat, const Wall wall)
  {
    return 2 * hat + (wall == Wall::plus);
  }
  unsigned int &
  facet(const unsigned int hat, const Wall wall)
  {
    return facets[place_of_wall(hat, wall)];
  }
  unsigned int
  facet(const unsigned int hat, const Wall wall) const
  {
    return facets[place_of_wall(hat, wall)];
  }

  /** The mean of a component of a wall's displacement, over the travel. */
  std::array<double, 2>
  moved(const unsigned int hat,
        const Wall wall,
        const typename ContactBasis<dim>::Component component) const;

  /** What the condition of a wall that sticks measures, over the travel; also
   * of another stage. */
  std::array<double, 2>
  moved_along_flank(const Condition &stick) const;
  /** Take the energy of the foundation out of that of the body. */
  void
  add_foundation_energy(Quadratic &energy) const;

  /** Forces of the conditions, each along its vectors, as forces on those of
   * the basis. */
  std::vector<double>
  forces_on_vectors(const std::function<double(unsigned int)> &force,
                    const VectorSum Condition::*along) const;

  /** The energy that friction takes for a multiplier of 1 while the blade
   * travels and a wall moves along and aside. */
  double
  dissipation(const Condition &condition,
              const double travel,
              const double along,
              const double aside) const;

  const std::unique_ptr<const ContactStage<dim>> stage;
  const ContactBasis<dim> &basis;
  const BladeProfile &profile;
  const SlidingBlade sliding;
  const double smallest_step;
  /** Where a blade that shifts was when this began, and stays while nothing
   * touches it. */
  double resting_shift = 0;

  /** Which way the blade goes. */
  int heading = 1;
  /** The facets of the hats' walls, and how these slip along them: forward, as
   * long as the blade has not turned. */
  std::vector<unsigned int> facets;
  std::vector<WallSlip> slips;
  bool has_turned = false;
  /** The walls that adhere, the friction that this is, and how it moves the
   * vectors; none where there is no adhesion. */
  std::vector<bool> adhering;
  std::vector<std::pair<Condition, double>> adhesions;
  std::vector<double> moved_by_adhesion;
  /** Where the corners on a board stick: what their vectors along it measure.
   */
  std::vector<std::array<double, dim - 1>> anchors;
  /** The corners that have come to stick since contacts were looked for. */
  std::vector<bool> has_stuck;
  std::vector<Condition> conditions;
  std::unique_ptr<Complementarity> problem;
  Complementarity::Piece piece;
  /** As energy() has found it for the piece; nothing before it is asked. */
  mutable std::optional<Quadratic> energy_of_piece;
  double end_of_piece = std::numeric_limits<double>::infinity();
  /** The condition that ends the piece, or the one that begins to slip and its
   * way, if it is no change of a facet. */
  std::optional<unsigned int> ending_condition;
  std::optional<std::pair<unsigned int, int>> ending_slip;
};
} // namespace Setsudan
