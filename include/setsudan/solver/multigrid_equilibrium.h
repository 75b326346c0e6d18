#pragma once

#include <setsudan/elasticity/cell_batches.h>
#include <setsudan/elasticity/elastic_model.h>
#include <setsudan/solver/equilibrium_solver.h>
#include <setsudan/solver/solver_parameters.h>

#include <memory>

namespace Setsudan
{
class ConstraintLines;
template <int dim>
class ConstrainedStiffness;
template <int dim>
class PMultigrid;

/** The equilibrium for one set of constraints without a matrix: conjugate
 * gradients, preconditioned by multigrid. */
template <int dim>
class MultigridEquilibrium : public EquilibriumSolver
{
public:
  using Vector = typename CellBatches<dim>::Vector;

  /** @param constraints homogeneous and closed, which must live as long. Their
   * local lines name every unknown that a constraint of this process couples.
   */
  MultigridEquilibrium(ElasticModel<dim> &model,
                       const dealii::AffineConstraints<double> &constraints,
                       const SolverParameters &parameters);

  ~MultigridEquilibrium() override;

  LA::Vector
  solve(const LA::Vector &forces,
        const LA::Vector &prescribed,
        const LA::Vector &guess) override;

  SolveQuality
  quality_of_last() const override;

  /** How many iterations the last solve took. */
  unsigned int
  n_iterations() const;

private:
  /** The loads that remain beside those of a prescribed displacement,
   * condensed. */
  Vector
  loads_beside(const LA::Vector &forces, const LA::Vector &prescribed) const;

  Vector
  imported(const LA::Vector &vector) const;

  LA::Vector
  exported(const Vector &vector) const;

  void
  iterate(Vector &x, const Vector &b);

  const dealii::AffineConstraints<double> &constraints;
  const SolverParameters parameters;
  ElasticModel<dim> &model;
  /** In the order in which each needs the one before. */
  std::unique_ptr<const ConstraintLines> lines;
  std::unique_ptr<const ConstrainedStiffness<dim>> stiffness;
  std::unique_ptr<const PMultigrid<dim>> multigrid;
  SolveQuality quality;
  unsigned int iterations = 0;
};
} // namespace Setsudan
