#pragma once

#include <setsudan/space/linear_algebra.h>

#include <functional>
#include <string>

namespace Setsudan
{
/** How good the result of a solve is. Round-off and the iterations' end lose
 * digits where the stiffness is very uneven or the body very slender. */
struct SolveQuality
{
  /** The residual, relative to the loads. */
  double residual = 0;
  /** How large about the largest displacement is to which that residual
   * belongs, relative to the largest one. */
  double estimated_relative_error = 0;
  /** What the user should know of how it was solved; mostly nothing. */
  std::string warning;
};

/** What holds of two solves together: the worse of each, and all remarks. */
SolveQuality
combine(const SolveQuality &a, const SolveQuality &b);

/** A solve is mended where its relative residual exceeds the first, and has
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

/** How a solution is mended. */
struct Refined
{
  /** What a solution leaves over of the loads. */
  std::function<LA::Vector(const LA::Vector &)> residual_of;
  /** The size of that. */
  std::function<double(const LA::Vector &)> norm;
  /** The displacement that it belongs to. */
  std::function<LA::Vector(const LA::Vector &)> correction;
};

/**
 * Solve for what a solution leaves over, and add that, as long as it lowers the
 * residual by half and the residual exceeds `wanted`.
 *
 * @return what is left over in the end.
 */
LA::Vector
iterative_refinement(LA::Vector &x,
                     const double wanted,
                     const Refined &mending);

/** @throw SolverError where the size of the loads is no number. */
void
check_loads(const double size);

/** The quality of a solution `x`, of which `correction` is about the error. */
SolveQuality
quality_of(const LA::Vector &x,
           const LA::Vector &correction,
           const double residual,
           const double loads);

/** The body's equilibrium for one set of constraints, in whichever way it is
 * prepared. */
class TangentSolver
{
public:
  virtual ~TangentSolver() = default;

  /**
   * The displacement under nodal forces.
   *
   * @param forces      without ghosts, no constraint applied.
   * @param prescribed  any displacement that obeys what is prescribed (the
   *   opening of a cut) besides the homogeneous constraints.
   * @param guess       a displacement near the solution.
   * @throw SolverError where the solver fails or its result does not fulfil
   *   the equations.
   */
  virtual LA::Vector
  solve(const LA::Vector &forces,
        const LA::Vector &prescribed,
        const LA::Vector &guess) = 0;

  virtual SolveQuality
  quality_of_last() const = 0;
};
} // namespace Setsudan
