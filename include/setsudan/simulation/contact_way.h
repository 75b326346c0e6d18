// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/nonlinear_contact.h>
#include <setsudan/solver/condensed/condensed_tangent.h>

#include <memory>
#include <optional>
#include <vector>

namespace Setsudan
{
/** What stays as it is while a cut has so many rows split. */
template <int dim>
struct NonlinearContact<dim>::Stage
{
  Stage(const NonlinearContact &contact,
        const unsigned int n_split,
        const unsigned int n_ahead);

  const unsigned int n_split;
  const unsigned int n_ahead;
  const typename CutBody<dim>::Constraints constraints;
  const std::vector<UnknownForces> springs;
  /** The numbers of the vectors that may be pressed on. */
  const std::vector<unsigned int> vectors;
  CondensedTangent<dim> tangent;
};



/** The way from one equilibrium to another: the blade moves, and what forces
 * and displacements lack where it begins, as those of ties that are released or
 * of supports that are moved, is made up for in proportion. */
template <int dim>
class NonlinearContact<dim>::Way
{
public:
  /** All must live as long.
   *
   * @param of_blade no profile where it is gone. */
  Way(const NonlinearContact &contact,
      Stage &stage,
      const BladeProfile &of_blade,
      const BladeMotion &motion,
      const Equilibrium &from);

  /** Go on from one part of the way to another; nothing where that fails.
   *
   * @throw NotDefiniteError where the tangent is not positive definite. */
  std::optional<Equilibrium>
  go(const Equilibrium &from, const double behind, const double part);

private:
  /** A displacement on the way, and the forces of contact with which it was
   * found. */
  struct Iterate
  {
    LA::Vector displacement;
    std::shared_ptr<ContactPath<dim>> path;
    LA::Vector contact_forces;
    /** What takes the springs out, see Foundation; empty where there are none.
     */
    LA::Vector foundation_forces;
    InternalForces internal;
    /** Under the loads of a part of the way. */
    double potential = 0;
    /** The norm of the residual of these and of contact, and relative to that
     * of all forces. */
    double residual          = 0;
    double relative_residual = 0;
  };

  /** The loads when a part of the way is behind. */
  LA::Vector
  loads_at(const double part) const;

  double
  travel_at(const double part) const
  {
    return begin_of_travel + part * (motion.travel - begin_of_travel);
  }

  /** Go towards where the tangent about a displacement is in equilibrium with
   * its contact, as search(). A tangent that is not positive definite, even
   * with contact, gets as much on its diagonal as it takes.
   *
   * @param prescribed how supports move. */
  std::optional<Iterate>
  step(const Iterate &about, const double part, const LA::Vector &prescribed);

  /** Where the tangent that has been taken is in equilibrium with its contact:
   * displacement and forces. */
  Iterate
  solve_tangent(const Iterate &about,
                const double part,
                const LA::Vector &prescribed) const;

  /** What the laws say about a displacement, and the residual there. */
  void
  evaluate(Iterate &iterate, const double part) const;

  /** The residual and the potential of what the laws have said. */
  void
  measure(Iterate &iterate, const double part) const;

  /** Go from one displacement towards another, as far as the energy falls, and
   * all the way where supports move.
   *
   * @param most_tries lengths, each half of the one before; nothing where it
   *   falls along none of them. */
  std::optional<Iterate>
  search(const Iterate &from,
         Iterate &&to,
         const double part,
         const LA::Vector &prescribed,
         const unsigned int most_tries) const;

  const NonlinearContact &contact;
  Stage &stage;
  const ElasticModel<dim> &model;
  const BladeProfile &of_blade;
  const BladeMotion motion;
  const double begin_of_travel;
  /** Where walls stick, and corners on a board, when it begins: not what they
   * did on the way to an equilibrium. */
  const std::shared_ptr<const ContactPath<dim>> earlier;
  /** The residual at the beginning, and what is prescribed and lacking there.
   */
  LA::Vector lacking;
  LA::Vector lacking_displacement;
  double size_of_forces;
  /** Whether the last step was one of the body's own tangent, and whether that
   * was taken for it. */
  bool is_exact = true;
  bool is_new   = false;
  SolveQuality quality;
};
} // namespace Setsudan
