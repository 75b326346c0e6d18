#pragma once

#include <setsudan/solver/solver_parameters.h>
#include <setsudan/space/linear_algebra.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace Setsudan
{
/** A solve did not give what it should; the message says which and why. */
class SolverError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

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

  /** About what solve() would give, in the least time: one application of the
   * factor or of the multigrid. */
  virtual void
  approximate(LA::Vector &x, const LA::Vector &b)
  {
    solve(x, b);
  }

  /** The method, in words. */
  virtual std::string
  description() const = 0;

  /** Whether it makes use of rigid modes and of a first guess. */
  virtual bool
  is_iterative() const
  {
    return false;
  }
};

/** The solver that the parameters ask for; `auto` decides by the size. The
 * direct one is KLU for small systems, CHOLMOD on one process, and MUMPS. */
std::unique_ptr<LinearSolver>
make_linear_solver(const SolverParameters &parameters,
                   const dealii::types::global_dof_index n_unknowns,
                   const MPI_Comm communicator);
} // namespace Setsudan
