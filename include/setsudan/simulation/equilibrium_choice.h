#pragma once

#include <setsudan/cut/seam/seam.h>
#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/simulation/scene.h>
#include <setsudan/solver/tangent_solver.h>

#include <functional>
#include <memory>
#include <string>

namespace Setsudan
{
template <int dim>
class CondensedSolver;
template <int dim>
class FallbackSolver;

/** Chooses how the states of a cut are solved, and keeps what each state can
 * take over from the one before. */
template <int dim>
class EquilibriumChoice
{
public:
  using Constraints = dealii::AffineConstraints<double>;

  /** How the constraints of other states than the present one are found. */
  struct OtherStates
  {
    /** The present state without the newest seam. */
    std::function<Constraints()> without_seam;
    /** Visits the constraints when each row of the newest seam in turn has been
     * split. */
    std::function<void(const std::function<void(const Constraints &)> &)>
      for_each_row;
  };

  /** @param scene must live as long. */
  explicit EquilibriumChoice(const Scene<dim> &scene);

  /** Do not prepare for more than one state of a cut. */
  void
  expect_single_states();

  /** Forget what has been prepared: more has changed than the newest seam's
   * ties. */
  void
  forget();

  /** Why the rows of a seam are not all solved from one factorization, in words
   * that follow "every row is solved anew"; empty where they are.
   *
   * @param seam the newest one; nothing where there is none. */
  std::string
  why_anew(const ElasticModel<dim> &model, const Seam<dim> *seam) const;

  /** Whether all rows are factored at once, since they are known to split.
   *
   * @param all_held whether no piece can come loose. */
  bool
  is_foreseen(const bool all_held) const;

  /** Multigrid is prepared anew behind so many rows. Each row in between takes
   * two iterations more than the one before, and has its coarse correction for
   * nothing. It is a fixed number so that a run which is resumed gets the same
   * digits. */
  static constexpr unsigned int rows_per_preparation = 4;

  /** The equilibrium under constraints. It may be the same object at the next
   * call, for others.
   *
   * @param n_split_rows of the newest seam. */
  std::shared_ptr<TangentSolver>
  solver(ElasticModel<dim> &model,
         const Seam<dim> *seam,
         const unsigned int n_split_rows,
         Constraints &&constraints,
         const bool all_held,
         const OtherStates &others);

  /** The equilibrium in all states of the newest cut, where it is prepared at
   * once; nothing where it is not. */
  std::shared_ptr<CondensedSolver<dim>>
  all_states(ElasticModel<dim> &model,
             const Seam<dim> *seam,
             const bool all_held,
             const OtherStates &others);

private:
  /** Factor the body for all states of a cut. */
  void
  condense(ElasticModel<dim> &model,
           const Seam<dim> &seam,
           const bool all_held,
           const OtherStates &others);

  /** What has failed once is not tried again. */
  void
  learn_from_ladder();

  const Scene<dim> &scene;
  bool has_single_states = false;
  bool has_fallen_back   = false;
  std::shared_ptr<CondensedSolver<dim>> condensed;
  /** The last one for a single state. */
  std::shared_ptr<FallbackSolver<dim>> ladder;
};
} // namespace Setsudan
