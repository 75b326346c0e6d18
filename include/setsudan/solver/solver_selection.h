// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/solver/condensed/unknown_forces.h>
#include <setsudan/solver/solver_choice.h>
#include <setsudan/solver/tangent_solver.h>

#include <functional>
#include <memory>
#include <vector>

namespace Setsudan
{
template <int dim>
class CondensedSolver;
template <int dim>
class FallbackSolver;

/** A cut whose states are to be solved one after another. */
struct CutStages
{
  using Constraints = dealii::AffineConstraints<double>;

  unsigned int n_rows = 0;
  /** The unknowns between which there are ties. */
  std::function<dealii::IndexSet()> interface_unknowns;
  /** What carries the body besides its supports: see CondensedSolver. */
  std::function<std::vector<UnknownForces>()> foundation = [] {
    return std::vector<UnknownForces>();
  };
  /** Whether the constraints of all states are known beforehand. */
  bool are_known = false;
  /** The closed constraints without the ties of this cut. */
  std::function<Constraints()> without_ties;
  /** Those with the first rows split, of 0 to n_rows. */
  std::function<Constraints(unsigned int n_split)> after;
};

/** Makes the solver of each state, in the way that choose_solver() and
 * choose_cut_strategy() say, and keeps what it can take over from the state
 * before. */
template <int dim>
class SolverSelection
{
public:
  using Constraints = dealii::AffineConstraints<double>;

  explicit SolverSelection(const SolverParameters &parameters);

  /** Forget what has been prepared: more has changed than the ties of a cut. */
  void
  forget();

  /** How often that was. */
  unsigned int
  n_forgotten() const
  {
    return forgotten;
  }

  /** The solver of a single state, chosen by what has been learnt so far. */
  Choice<SolverKind>
  choice(const ElasticModel<dim> &model) const;

  /**
   * The solver under closed constraints. It may be the same object at the next
   * call, for others.
   *
   * @param stages of the cut that is being made; null where there is none, or
   *   no more than this state of it will be solved.
   */
  std::shared_ptr<TangentSolver>
  solver(const ElasticModel<dim> &model,
         std::shared_ptr<const Constraints> constraints,
         const CutStages *stages);

private:
  /** Factor the body for all states of a cut. */
  std::shared_ptr<CondensedSolver<dim>>
  condense(const ElasticModel<dim> &model, const CutStages &stages) const;

  /** What has failed once is not tried again. */
  void
  learn();

  const SolverParameters parameters;
  bool has_fallen_back = false;
  std::shared_ptr<CondensedSolver<dim>> condensed;
  /** The last one for a single state, and how many before it have the same
   * coarse correction. */
  std::shared_ptr<FallbackSolver<dim>> single;
  unsigned int n_reused  = 0;
  unsigned int forgotten = 0;
};
} // namespace Setsudan
