// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/solver/condensed/unknown_forces.h>
#include <setsudan/solver/constrained_solver.h>
#include <setsudan/solver/linear/linear_solver.h>
#include <setsudan/solver/solver_choice.h>

#include <memory>
#include <optional>
#include <vector>

namespace Setsudan
{
/** A tangent solver with the assembled matrix, which any number of loads are
 * solved with. */
template <int dim>
class AssembledSolver : public ConstrainedSolver<dim>
{
public:
  /** As the base. In a linear body it is ready; in others linearize() comes
   * first.
   *
   * @param kind any of which the matrix is assembled.
   * @param springs stiffness beside that of the elements, v v^T for each v, the
   *   same on all processes; the unknowns of each are those of cells around a
   *   vertex. */
  AssembledSolver(const ElasticModel<dim> &model,
                  const dealii::AffineConstraints<double> &constraints,
                  const SolverParameters &parameters,
                  const SolverKind kind,
                  std::vector<UnknownForces> springs = {});

  /** Take the tangent about another displacement.
   *
   * @param shift what is added to its diagonal, in relation to the mean of
   *   that.
   * @throw NotDefiniteError where it is not positive definite; of an iterative
   *   solver solves do. */
  void
  linearize(const Linearization &linearization, const double shift = 0);

  /** How many eigenvalues of the tangent are negative; nothing where its kind
   * does not tell. */
  std::optional<unsigned int>
  n_negative() const
  {
    return solver->n_negative();
  }

  /** The norm of what internal forces lose to round-off of the nodes'
   * positions, of a body at rest too. */
  double
  round_off() const;

private:
  /** Solve, with iterative refinement. */
  LA::Vector
  solve_condensed(const LA::Vector &b,
                  const LA::Vector &guess,
                  SolveQuality &quality) override;

  [[noreturn]] void
  fail(const double residual) const;

  using ConstrainedSolver<dim>::model;
  using ConstrainedSolver<dim>::constraints;
  using ConstrainedSolver<dim>::accepted;

  /** Keep the springs that this process adds: each has one that knows the
   * constraints of all of its unknowns. */
  void
  share_out_springs();

  void
  add_springs();

  const SolverKind kind;
  std::vector<UnknownForces> springs;
  LA::SparseMatrix matrix;
  /** Behind the matrix, which must outlive it. */
  std::unique_ptr<LinearSolver> solver;
};
} // namespace Setsudan
