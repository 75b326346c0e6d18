// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/solver/assembled_solver.h>
#include <setsudan/solver/tangent_iteration.h>

#include <cmath>
#include <memory>
#include <optional>

namespace Setsudan
{
/** A displacement on the way. */
struct NewtonIterate
{
  LA::Vector displacement;
  InternalForces internal;
  /** Condensed, and its norm beside that of the forces. */
  LA::Vector residual;
  double relative_residual = 0;
  /** The potential energy under the forces. */
  double potential = 0;
  /** The steps that led to it. */
  unsigned int n_steps = 0;

  bool
  is_valid() const
  {
    return internal.energy.is_finite();
  }
};

/**
 * The way from a state to that under other loads, ties and prescribed
 * displacements: the residual that the first state has under these, and what it
 * lacks of what is prescribed, are taken off in proportion.
 */
template <int dim>
class NewtonPath
{
public:
  using Constraints = dealii::AffineConstraints<double>;

  enum class Tangent
  {
    /** See LawIntegration. */
    extrapolated,
    exact
  };

  /** All must live as long.
   *
   * @param start  of the way.
   * @param factor see TangentIteration. */
  NewtonPath(const ElasticModel<dim> &model,
             const Constraints &constraints,
             const SolverParameters &parameters,
             const LA::Vector &forces,
             const LA::Vector &lift,
             const LA::Vector &start,
             std::shared_ptr<CondensedSolver<dim>> factor);

  /** The size of the internal forces there, or of a small part of what the body
   * resists the prescribed displacement with: what is left counts beside it. */
  double
  size_of_first_forces() const
  {
    return size_of_forces;
  }

  /** The state from which the way begins. */
  const NewtonIterate &
  beginning() const
  {
    return first;
  }

  /**
   * Go on from one part of the way to another; nothing where that fails, as
   * where the tangent is not positive definite in the end.
   *
   * @param from solved.
   * @throw NotDefiniteError where the exact tangent is not positive definite on
   *   the way.
   */
  std::optional<NewtonIterate>
  go(const NewtonIterate &from,
     const double part_of_from,
     const double part,
     const Tangent tangent);

  /** Of the solves so far. */
  SolveQuality quality;

private:
  /** The forces when a part of the way is behind. */
  LA::Vector
  forces_at(const double part) const;

  NewtonIterate
  evaluate(const LA::Vector &displacement, const double part) const;

  bool
  is_solved(const NewtonIterate &now, const NewtonIterate &before) const;

  /** Take the step that a residual asks for, as far as the energy falls;
   * nothing where it does not. */
  std::optional<NewtonIterate>
  search(const NewtonIterate &from,
         const LA::Vector &step,
         const double part) const;

  /** Set the tangent, and solve with it.
   *
   * @param relative_residual how far the state is from a solution.
   * @param may_be_indefinite whether that is no failure. */
  LA::Vector
  step(const Linearization &linearization,
       const LA::Vector &residual,
       const double relative_residual,
       const bool may_be_indefinite);

  /** The same with a tangent that is positive definite.
   *
   * @throw NotDefiniteError where it is seen that it is not. */
  LA::Vector
  definite_step(const Linearization &linearization,
                const LA::Vector &residual,
                const double tolerance);

  /** Whether the exact tangent is positive definite: a factor proves it, and an
   * iteration finds no direction in which it is not. */
  bool
  is_stable(const LA::Vector &displacement);

  const ElasticModel<dim> &model;
  const Constraints &constraints;
  const SolverParameters &parameters;
  const LA::Vector &forces;
  NewtonIterate first;
  /** The residual at the start, and what is prescribed and lacking there. */
  LA::Vector lacking_forces;
  LA::Vector lacking_displacement;
  /** See size_of_first_forces(). */
  double size_of_forces;
  AssembledSolver<dim> solver;
  const bool is_small;
  /** What is taken in its place, until it fails. */
  std::unique_ptr<TangentIteration<dim>> iteration;
  /** Of matrices that are not definite; made where there are any. */
  std::unique_ptr<AssembledSolver<dim>> indefinite_solver;
  bool last_was_definite = true;
};
} // namespace Setsudan
