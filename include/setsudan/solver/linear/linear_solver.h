// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/parameters/exceptions.h>
#include <setsudan/solver/solver_choice.h>
#include <setsudan/space/linear_algebra.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace Setsudan
{

/**
 * A way to solve A x = b for one symmetric positive definite matrix after
 * another, each with several right-hand sides.
 */
class LinearSolver
{
public:
  virtual ~LinearSolver() = default;

  /**
   * Take a matrix, which must live as long as it is solved with.
   *
   * @param rigid_modes for each rigid motion its value in every unknown of
   * this process: what multigrid needs to know of elasticity.
   */
  virtual void
  initialize(const LA::SparseMatrix &matrix,
             const std::vector<std::vector<double>> &rigid_modes) = 0;

  /**
   * Solve; `x` holds the first guess.
   *
   * @throw SolverError where it fails.
   */
  virtual void
  solve(LA::Vector &x, const LA::Vector &b) = 0;

  /**
   * An approximation of solve() in the least time: one application of the
   * factor or of the multigrid.
   */
  virtual void
  approximate(LA::Vector &x, const LA::Vector &b)
  {
    solve(x, b);
  }

  /** Whether it makes use of rigid modes and of a first guess. */
  virtual bool
  is_iterative() const
  {
    return false;
  }
};

/** @param kind any of which the matrix is assembled. */
std::unique_ptr<LinearSolver>
make_linear_solver(const SolverKind kind, const SolverParameters &parameters);
} // namespace Setsudan
