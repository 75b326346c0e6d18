// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/space/discretization.h>
#include <setsudan/space/linear_algebra.h>

#include <functional>
#include <string>

namespace Setsudan
{
/** The accuracy of a solve. Round-off and the iterations' end lose digits where
 * the stiffness is very uneven or the body very slender. */
struct SolveQuality
{
  /** The residual, relative to the loads. */
  double residual = 0;
  /** Estimate of the largest error of the displacement, from that residual,
   * relative to the largest displacement. */
  double estimated_relative_error = 0;
  /** A message to the user about the way of the solve; empty in most cases. */
  std::string warning;
  /** The size of forces that the residual is relative to where that is more
   * than those of the state itself. */
  double force_scale = 0;
};

/**
 * The quality of two solves together: the worse of each number, and all
 * warnings.
 */
SolveQuality
combine(const SolveQuality &a, const SolveQuality &b);

/** The solution of a body's equilibrium; no vector has ghosts. */
struct Solution
{
  LA::Vector displacement;
  /** The internal forces F(u), K u in a linear body, no constraint applied. */
  LA::Vector internal;
  SolveQuality quality;
  /** The steps of Newton's method; 0 in a linear body. */
  unsigned int n_steps = 0;
};

/** A solve is refined where its relative residual exceeds the first, and has
 * failed where it exceeds the second. */
inline constexpr double refinement_threshold = 1e-13;
inline constexpr double failure_threshold    = 1e-8;

/**
 * Whether a solve is good enough: its residual is small beside the loads, or is
 * what the products in K x lose to round-off at best.
 *
 * @param norm_of_matrix the largest sum of a row's magnitudes in K.
 */
bool
converged(const double residual,
          const double loads,
          const double norm_of_matrix,
          const LA::Vector &x,
          const double accepted = failure_threshold);

/** What iterative refinement needs of a system of equations. */
struct RefinedSystem
{
  /** The residual of a solution. */
  std::function<LA::Vector(const LA::Vector &)> residual_of;
  /** The norm of a residual. */
  std::function<double(const LA::Vector &)> norm;
  /** The solution for a residual. */
  std::function<LA::Vector(const LA::Vector &)> correction;
};

/**
 * Iterative refinement: solve for the residual and add the correction while it
 * reduces the residual by at least one half and the residual exceeds `wanted`.
 *
 * @return the residual in the end.
 */
LA::Vector
iterative_refinement(LA::Vector &x,
                     const double wanted,
                     const RefinedSystem &system);

/** The norm of what internal forces lose to round-off of the nodes' positions,
 * of a body at rest too.
 *
 * @param norm_of_matrix as for converged(). */
template <int dim>
double
round_off_of_forces(const Discretization<dim> &discretization,
                    const double norm_of_matrix);

/** @throw SolverError where the norm of the loads is no number. */
void
check_loads(const double norm);

/** The quality of a solution `x`, of which `correction` is about the error. */
SolveQuality
quality_of(const LA::Vector &x,
           const LA::Vector &correction,
           const double residual,
           const double loads);

/** Solves the equilibrium K u = f, or F(u) = f in a body that is not linear,
 * under one set of homogeneous constraints, in whichever way it is prepared. */
class TangentSolver
{
public:
  virtual ~TangentSolver() = default;

  /**
   * @param forces external nodal forces, without ghosts, no constraint applied.
   * @param lift   any displacement that has what is prescribed (by clamps, or
   *   the opening of a cut) besides the homogeneous constraints.
   * @param guess  a displacement near the solution.
   * @throw SolverError where the solver fails or its result does not fulfil
   *   the equations.
   */
  virtual Solution
  solve(const LA::Vector &forces,
        const LA::Vector &lift,
        const LA::Vector &guess) = 0;
};
} // namespace Setsudan
