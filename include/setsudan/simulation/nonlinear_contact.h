// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/contact_base.h>

#include <list>
#include <memory>
#include <optional>
#include <vector>

namespace Setsudan
{
/** A body in equilibrium with the blade that touches it. */
template <int dim>
struct ContactEquilibrium
{
  /** How many rows are split. */
  unsigned int n_split = 0;
  double travel        = 0;
  LA::Vector displacement;
  /** The forces of contact; null where they have not been looked for yet. They
   * are those of the body's tangent there, and linear in the travel near it. */
  std::shared_ptr<ContactPath<dim>> path;
  /** The internal forces, and the energy that is stored and that of pressures.
   */
  InternalForces internal;
  /** What is stored and lost, and the potential energy of the loads, without
   * the forces of contact. */
  double energy = 0;
  SolveQuality quality;
  /** The steps of Newton's method that led to it. */
  unsigned int n_steps = 0;

  /** The potential energy of which this is the minimum, see Energy. */
  double
  potential() const
  {
    return energy - internal.energy.total() + internal.energy.potential;
  }
};

/**
 * The contact of a blade with the newest cut of a body that is not linear.
 *
 * The conditions of contact are linear in the displacement, see
 * ContactCondition: each wall is kept off the half plane of its own facet of
 * the blade, and the front off the half plane ahead of the edge. Newton's
 * method takes the tangent of the body, about a displacement u, for a linear
 * body: this goes to u + K^-1 (f - F(u)) without contact, and a force along a
 * vector of contact moves it by K^-1 times that. Its contact is found as that
 * of any linear body, and the displacement with it is the next u; the energy
 * must fall on the way. Since all of these u but the first fulfil the
 * conditions, there is no stiffness of contact to choose.
 */
template <int dim>
class NonlinearContact : private ContactBase<dim>
{
public:
  using Equilibrium = ContactEquilibrium<dim>;

  /** @param body, profile must live as long.
   * @param displacement as for ContactBase. */
  NonlinearContact(CutBody<dim> &body,
                   const BladeProfile &profile,
                   const LA::Vector &displacement);

  ~NonlinearContact();

  /** Whether this is of what the body is now. */
  bool
  is_of_present_body() const
  {
    return n_changes == body.n_changes();
  }

  /** The equilibrium from which all others are reached.
   *
   * @param displacement near it, without ghosts. */
  Equilibrium
  begin(const unsigned int n_split,
        const unsigned int n_ahead,
        const BladeMotion &motion,
        const LA::Vector &displacement) const;

  /**
   * The equilibrium with the blade somewhere else, or with more rows split.
   *
   * @param n_ahead how many rows may split next.
   * @param motion of the blade, with its travel.
   * @throw NoEquilibriumError where there is none that is stable; it says how
   *   far the way could be followed.
   */
  Equilibrium
  reach(const unsigned int n_split,
        const unsigned int n_ahead,
        const BladeMotion &motion,
        const Equilibrium &from) const;

  /** The same with all rows split and the blade gone; of a body without a cut,
   * on its board. */
  Equilibrium
  without_blade(const BladeMotion &motion, const Equilibrium &from) const;

  /** @param row on which the blade rests. */
  State<dim>
  state(const Equilibrium &equilibrium, const unsigned int row) const;

private:
  class Way;
  struct Stage;

  /** What a stage of the cut has, which is kept while it is one of the last
   * that were asked for. */
  Stage &
  stage(const unsigned int n_split, const unsigned int n_ahead) const;

  /** Some of the vectors of contact. */
  std::vector<UnknownForces>
  vectors_of(const std::vector<unsigned int> &numbers) const;

  /** Forces along all of them, on all unknowns. */
  LA::Vector
  on_body(const std::vector<double> &forces) const;

  /** The springs that carry the body while its contacts with a board are looked
   * for, see BoardContacts. */
  std::vector<UnknownForces>
  springs() const;

  Equilibrium
  follow(const BladeProfile &of_blade,
         const unsigned int n_split,
         const unsigned int n_ahead,
         const BladeMotion &motion,
         const Equilibrium &from) const;

  using ContactBase<dim>::body;
  using ContactBase<dim>::profile;
  using ContactBase<dim>::basis;
  /** What the body was when this began. */
  const unsigned int n_changes;
  /** The last one first. */
  mutable std::list<Stage> stages;
};
} // namespace Setsudan
