#pragma once

#include <setsudan/elasticity/linear_algebra.h>

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
  double uncertainty = 0;
};

/** A solve is mended where its relative residual exceeds the first, and has
 * failed where it exceeds the second. */
inline constexpr double refined_above = 1e-13;
inline constexpr double failed_above  = 1e-8;

/** The body's equilibrium for one set of constraints, in whichever way it is
 * prepared. */
class EquilibriumSolver
{
public:
  virtual ~EquilibriumSolver() = default;

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
