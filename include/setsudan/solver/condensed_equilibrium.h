#pragma once

#include <setsudan/elasticity/elastic_model.h>
#include <setsudan/solver/equilibrium_solver.h>
#include <setsudan/solver/growing_cholesky.h>
#include <setsudan/solver/schur_complement.h>

#include <memory>
#include <utility>
#include <vector>

namespace Setsudan
{
/**
 * The equilibrium of a body in which ties between some unknowns, those of a
 * cut, are taken off step by step: exact in every step, from one factorization.
 *
 * All other unknowns are eliminated once. What remains is S, the stiffness that
 * the cut's unknowns have. In each step they are combinations Q q of those
 * which the ties leave free, and Q^T S Q is factored; taking off ties adds
 * columns to Q and leaves the others as they are, so that the factor grows and
 * is never made anew. A step costs as many operations as it has new unknowns,
 * times the square of those of the cut.
 *
 * One process only.
 */
template <int dim>
class CondensedEquilibrium : public EquilibriumSolver
{
public:
  using Constraints = dealii::AffineConstraints<double>;

  /**
   * @param base what holds in all steps, closed.
   * @param cut  the unknowns between which there are ties.
   */
  CondensedEquilibrium(ElasticModel<dim> &model,
                       std::shared_ptr<const Constraints> base,
                       const dealii::IndexSet &cut);

  /**
   * Go to a step.
   *
   * @param step closed: `base`, and ties among the unknowns of the cut.
   * What the last step has and this one does not forbid is kept, so that it
   * takes least where ties are only taken off, or put on again in the opposite
   * order.
   *
   * @return false where a tie leads out of the cut, and nothing has changed.
   */
  bool
  set_constraints(std::shared_ptr<const Constraints> step);

  LA::Vector
  solve(const LA::Vector &forces,
        const LA::Vector &prescribed,
        const LA::Vector &guess) override;

  SolveQuality
  quality_of_last() const override;

  /** Bytes that the condensation of so many unknowns of a cut takes besides the
   * factor. */
  static double
  memory(const unsigned int n_unknowns_of_cut);

private:
  /** A column of Q: unknowns of the cut, by their place there, and factors. */
  using Column = std::vector<std::pair<unsigned int, double>>;

  /** The columns of a step's free unknowns, in the order of the cut; nothing
   * where a tie leads out of the cut. */
  bool
  columns_of(const Constraints &step,
             std::vector<unsigned int> &free,
             std::vector<Column> &columns) const;

  /** How many of the columns of Q, from the first, obey the ties of a step. */
  unsigned int
  n_that_fit(const std::vector<unsigned int> &free,
             const std::vector<Column> &columns) const;

  void
  append(const std::vector<Column> &columns);

  /** CholeskyFactor::eliminate(), or what it made of the last loads that are
   * remembered, where they are the same but for those on the cut. */
  void
  eliminate(std::vector<double> &ordered, const bool is_remembered);

  /** The displacement that forces give, both obeying `base`, and the
   * displacement but for the `opening` the step.
   *
   * @param opening what the cut's unknowns have besides; nothing if it is zero.
   */
  LA::Vector
  solve_for(const LA::Vector &b,
            const std::vector<double> &opening,
            const bool is_remembered);

  /** What a displacement has on the cut, nothing if it is zero; the rest of it
   * is left over. */
  std::vector<double>
  take_opening(LA::Vector &prescribed) const;

  /** Set the quality of a solution.
   *
   * @throw SolverError where it is not good enough. */
  void
  judge(const LA::Vector &x,
        const LA::Vector &rest,
        const double scale,
        const Mending &mending);

  [[noreturn]] void
  fail() const;

  ElasticModel<dim> &model;
  const std::shared_ptr<const Constraints> base;
  std::shared_ptr<const Constraints> step;
  /** The unknowns of the cut that `base` leaves free, ascending. */
  std::vector<unsigned int> cut;
  std::unique_ptr<CholeskyFactor> factor;
  std::unique_ptr<SchurComplement> complement;
  std::unique_ptr<GrowingCholesky> reduced;
  /** The largest sum of a row of the stiffness. */
  double largest_entry = 0;
  /** The unknown of each column of Q. */
  std::vector<unsigned int> free_unknowns;
  std::vector<Column> basis;
  std::vector<double> remembered_loads, remembered;
  SolveQuality quality;
  /** The displacement for a residual of 1, and the largest displacement for
   * loads of size 1, when the quality was last looked at closely. */
  double per_residual = 0, known_compliance = 0;
};
} // namespace Setsudan
