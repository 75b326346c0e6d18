// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/cell_batches.h>
#include <setsudan/solver/constrained_solver.h>

#include <memory>

namespace Setsudan
{
class LocalConstraints;
template <int dim>
class CondensedSolver;
template <int dim>
class ConstrainedStiffness;
template <int dim>
class PMultigrid;

/**
 * Conjugate gradients with the tangent of a deformed body, for one tangent
 * after another. It is not assembled where the kernels know it (see
 * has_law_kernel()).
 *
 * The preconditioner is that of the body at rest: the factor of its cut, which
 * knows all states of it, or p-multigrid. Either is made anew about the present
 * tangent where the iterations become many; the factor is kept so for the
 * states that follow.
 */
template <int dim>
class TangentIteration : public ConstrainedSolver<dim>
{
public:
  using Vector  = typename CellBatches<dim>::Vector;
  using Tangent = typename CellBatches<dim>::Tangent;

  /** As the base.
   *
   * @param factor at these constraints, of whichever tangent; nothing for
   *   multigrid, which is for tangents that are not assembled. */
  TangentIteration(const ElasticModel<dim> &model,
                   const dealii::AffineConstraints<double> &constraints,
                   const SolverParameters &parameters,
                   std::shared_ptr<CondensedSolver<dim>> factor);

  ~TangentIteration() override;

  /** Take the tangent about another displacement, which must live until it is
   * solved with.
   *
   * @param tolerance the relative residual at which increment() may end. */
  void
  linearize(const Linearization &linearization, const double tolerance);

  /** How many iterations there have been. */
  unsigned int
  n_iterations() const
  {
    return iterations;
  }

private:
  /** @throw NotDefiniteError where a direction shows that the tangent is not
   *   positive definite: it need not show.
   * @throw SolverError where the iteration does not converge. */
  LA::Vector
  solve_condensed(const LA::Vector &b,
                  const LA::Vector &guess,
                  SolveQuality &quality) override;

  /**
   * Iterate until the residual is small enough, or so often.
   *
   * @param residual of x; is updated, as x is.
   * @return whether it is small enough. */
  bool
  iterate(Vector &x,
          Vector &residual,
          const double wanted,
          const unsigned int most);

  /** The product with the tangent. */
  void
  multiply(Vector &result, const Vector &direction) const;

  void
  precondition(Vector &result, const Vector &residual) const;

  /** Make the preconditioner for the present tangent. */
  void
  precondition_anew();

  /** Make multigrid for a tangent, or for the body at rest. */
  void
  make_multigrid(std::shared_ptr<const Tangent> about);

  using ConstrainedSolver<dim>::model;
  using ConstrainedSolver<dim>::constraints;

  const std::shared_ptr<CondensedSolver<dim>> factor;
  const bool has_kernel;
  Linearization present;
  double tolerance        = 0;
  unsigned int iterations = 0;
  /** In the order in which each needs the one before. */
  std::unique_ptr<const LocalConstraints> local_constraints;
  std::shared_ptr<const Tangent> tangent;
  std::unique_ptr<const ConstrainedStiffness<dim>> matrix, of_multigrid;
  std::unique_ptr<const PMultigrid<dim>> multigrid;
  /** Of laws that the kernels do not know. */
  LA::SparseMatrix assembled;
};
} // namespace Setsudan
