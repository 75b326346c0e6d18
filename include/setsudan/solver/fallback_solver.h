#pragma once

#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/solver/solver_parameters.h>
#include <setsudan/solver/tangent_solver.h>

#include <memory>
#include <string>

namespace Setsudan
{
template <int dim>
class AssembledSolver;
template <int dim>
class MatrixFreeSolver;

/**
 * The equilibrium for one set of constraints by the solver that suits the
 * body: the direct one; or multigrid over the order of the functions, and one
 * of the assembled matrix where that does not converge.
 */
template <int dim>
class FallbackSolver : public TangentSolver
{
public:
  using Constraints = dealii::AffineConstraints<double>;

  /**
   * @param has_fallen_back whether multigrid has failed before and is not to be
   *   tried.
   * @param last            the ladder for the same model under other
   * constraints, of which is kept what serves here; or nothing.
   */
  FallbackSolver(ElasticModel<dim> &model,
                 std::shared_ptr<const Constraints> constraints,
                 const SolverParameters &parameters,
                 const bool has_fallen_back      = false,
                 const FallbackSolver<dim> *last = nullptr);

  ~FallbackSolver() override;

  LA::Vector
  solve(const LA::Vector &forces,
        const LA::Vector &prescribed,
        const LA::Vector &guess) override;

  SolveQuality
  quality_of_last() const override;

  /** Whether multigrid has failed. */
  bool
  has_fallen_back() const;

  /** The solver that is tried first, in words. */
  static std::string
  description(const ElasticModel<dim> &model,
              const SolverParameters &parameters);

private:
  /** Whether there is a multigrid for this body, and it is to be used. */
  static bool
  is_matrix_free(const ElasticModel<dim> &model,
                 const SolverParameters &parameters);

  void
  assemble();

  ElasticModel<dim> &model;
  const std::shared_ptr<const Constraints> constraints;
  SolverParameters parameters;
  std::unique_ptr<MatrixFreeSolver<dim>> multigrid;
  std::unique_ptr<AssembledSolver<dim>> assembled;
  /** What went wrong with multigrid, until it has been said. */
  std::string failure;
  bool fell_back;
  SolveQuality quality;
};
} // namespace Setsudan
