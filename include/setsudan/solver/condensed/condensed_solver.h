#pragma once

#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/solver/condensed/interface_system.h>
#include <setsudan/solver/condensed/static_condensation.h>
#include <setsudan/solver/tangent_solver.h>

#include <memory>
#include <vector>

namespace Setsudan
{
/**
 * The equilibrium of a body in which ties between some unknowns, those of a
 * cut, are taken off step by step: exact in every step, from one factorization.
 *
 * All other unknowns are eliminated once. What remains is the stiffness that
 * the cut's unknowns have, and of it each step takes what its ties leave: see
 * InterfaceSystem.
 *
 * One process only.
 */
template <int dim>
class CondensedSolver : public TangentSolver
{
public:
  using Constraints = dealii::AffineConstraints<double>;

  /**
   * @param base what holds in all steps, closed.
   * @param cut  the unknowns between which there are ties.
   */
  CondensedSolver(ElasticModel<dim> &model,
                  std::shared_ptr<const Constraints> base,
                  const dealii::IndexSet &cut);

  /** Go to a step: see InterfaceSystem::set_constraints().
   *
   * @param step closed: `base`, and ties among the unknowns of the cut.
   * @return false where a tie leads out of the cut, and nothing has changed. */
  bool
  set_constraints(std::shared_ptr<const Constraints> step);

  /** Remember later steps, and factor them at once: see InterfaceSystem. */
  bool
  append_stage(const Constraints &later);
  void
  factorize_foreseen();

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
  /** StaticCondensation::forward_eliminate(), or what it made of the last loads
   * that are remembered, where they are the same but for those on the cut. */
  StaticCondensation::Eliminated
  forward_eliminate(const LA::Vector &loads, const bool is_remembered);

  /** The displacement that forces give, both obeying `base`, and the
   * displacement but for the `opening` the step.
   *
   * @param opening what the cut's unknowns have besides; nothing if it is zero.
   */
  LA::Vector
  solve_for(const LA::Vector &b,
            const std::vector<double> &opening,
            const bool is_remembered);

  /** The forces less what a displacement off the cut takes of them. */
  LA::Vector
  loads_beside(const LA::Vector &forces, const LA::Vector &beyond_cut);

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
        const Refined &mending);

  [[noreturn]] void
  fail() const;

  ElasticModel<dim> &model;
  const std::shared_ptr<const Constraints> base;
  std::shared_ptr<const Constraints> step;
  /** The unknowns of the cut that `base` leaves free, ascending. */
  std::vector<unsigned int> cut;
  std::unique_ptr<StaticCondensation> condensation;
  std::unique_ptr<InterfaceSystem> reduced;
  /** The largest sum of a row of the stiffness. */
  double largest_entry = 0;
  /** The last displacement beyond the cut that was prescribed, and K times it.
   */
  LA::Vector remembered_beyond, forces_of_beyond;
  LA::Vector remembered_loads;
  StaticCondensation::Eliminated remembered;
  SolveQuality quality;
  /** The displacement for a residual of 1, and the largest displacement for
   * loads of size 1, when the quality was last looked at closely. */
  double per_residual = 0, known_compliance = 0;
};
} // namespace Setsudan
