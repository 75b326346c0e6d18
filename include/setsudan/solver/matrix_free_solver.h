// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/cell_batches.h>
#include <setsudan/solver/constrained_solver.h>

#include <memory>

namespace Setsudan
{
class LocalConstraints;
template <int dim>
class ConstrainedStiffness;
template <int dim>
class PMultigrid;
template <int dim>
class CoarseCorrection;

/** A tangent solver without a matrix: conjugate gradients, preconditioned by
 * p-multigrid. */
template <int dim>
class MatrixFreeSolver : public ConstrainedSolver<dim>
{
public:
  using Vector = typename CellBatches<dim>::Vector;

  /** As the base.
   *
   * @param last the solver under constraints that were a little different,
   * whose coarse correction is kept if it serves here; or nothing. */
  MatrixFreeSolver(const ElasticModel<dim> &model,
                   const dealii::AffineConstraints<double> &constraints,
                   const SolverParameters &parameters,
                   const MatrixFreeSolver<dim> *last = nullptr);

  ~MatrixFreeSolver() override;

  /** How many iterations the last solve took. */
  unsigned int
  n_iterations() const;

private:
  LA::Vector
  solve_condensed(const LA::Vector &b,
                  const LA::Vector &guess,
                  SolveQuality &quality) override;

  /** @param residual of x in the end. */
  void
  iterate(Vector &x, const Vector &b, Vector &residual);

  [[noreturn]] void
  fail(const double residual) const;

  using ConstrainedSolver<dim>::accepted;

  const unsigned int max_iterations;
  const double tolerance;
  /** In the order in which each needs the one before. */
  std::unique_ptr<const LocalConstraints> local_constraints;
  std::unique_ptr<const ConstrainedStiffness<dim>> stiffness;
  std::shared_ptr<const CoarseCorrection<dim>> coarse;
  std::unique_ptr<const PMultigrid<dim>> multigrid;
  unsigned int iterations = 0;
};
} // namespace Setsudan
