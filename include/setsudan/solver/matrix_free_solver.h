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

/** The equilibrium for one set of constraints without a matrix: conjugate
 * gradients, preconditioned by multigrid. */
template <int dim>
class MatrixFreeSolver : public ConstrainedSolver<dim>
{
public:
  using Vector = typename CellBatches<dim>::Vector;

  /** As the base.
   *
   * @param last the equilibrium under constraints that were a little different,
   *   whose coarse correction is kept if it serves here; or nothing. */
  MatrixFreeSolver(ElasticModel<dim> &model,
                   const dealii::AffineConstraints<double> &constraints,
                   const SolverParameters &parameters,
                   const MatrixFreeSolver<dim> *last = nullptr);

  ~MatrixFreeSolver() override;

  /** How many iterations the last solve took. */
  unsigned int
  n_iterations() const;

private:
  LA::Vector
  solve_condensed(const LA::Vector &b, const LA::Vector &guess) override;

  /** @param rest what is left over in the end. */
  void
  iterate(Vector &x, const Vector &b, Vector &rest);


  [[noreturn]] void
  fail() const;

  using ConstrainedSolver<dim>::accepted;
  using ConstrainedSolver<dim>::quality;

  const unsigned int max_iterations;
  const double tolerance;
  /** In the order in which each needs the one before. */
  std::unique_ptr<const LocalConstraints> lines;
  std::unique_ptr<const ConstrainedStiffness<dim>> stiffness;
  std::shared_ptr<const CoarseCorrection<dim>> coarse;
  std::unique_ptr<const PMultigrid<dim>> multigrid;
  unsigned int iterations = 0;
};
} // namespace Setsudan
