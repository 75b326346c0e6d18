#pragma once

#include <deal.II/lac/trilinos_precondition.h>

#include <setsudan/solver/linear_solver.h>

namespace Setsudan
{
/** Conjugate gradients, preconditioned by Trilinos' smoothed aggregation (ML)
 * that knows the rigid motions of the body. */
class IterativeSolver : public LinearSolver
{
public:
  explicit IterativeSolver(const SolverParameters &parameters);

  void
  initialize(const LA::SparseMatrix &matrix,
             const std::vector<std::vector<double>> &rigid_modes) override;

  void
  solve(LA::Vector &x, const LA::Vector &b) override;

  void
  approximate(LA::Vector &x, const LA::Vector &b) override;

  std::string
  description() const override;

  bool
  is_iterative() const override;

private:
  const SolverParameters parameters;
  const LA::SparseMatrix *matrix = nullptr;
  dealii::TrilinosWrappers::PreconditionAMG multigrid;
  /** The modes, one behind the other; ML keeps a pointer to them. */
  std::vector<double> null_space;
};
} // namespace Setsudan
