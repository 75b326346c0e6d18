// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/solver/condensed/interface_system.h>
#include <setsudan/solver/condensed/static_condensation.h>
#include <setsudan/solver/tangent_solver.h>

#include <functional>
#include <memory>
#include <vector>

namespace Setsudan
{
/**
 * A tangent solver for all states of a cut, in which ties between the interface
 * unknowns are taken off stage by stage: exact in every stage, from one
 * factorization.
 *
 * All other unknowns are eliminated once (StaticCondensation). The state of the
 * interface is found on its Schur complement (InterfaceSystem), and the rest of
 * the body follows from it by back substitution.
 *
 * Of several processes the first one has the factorization and solves with it;
 * the others wait.
 */
template <int dim>
class CondensedSolver : public TangentSolver
{
public:
  using Constraints = dealii::AffineConstraints<double>;

  /**
   * @param base constraints that hold in all stages, closed.
   * @param cut  the interface unknowns, between which there are ties.
   * @param foundation vectors v of interface unknowns, the same on all
   *   processes. The stiffness that is solved with is K + sum of v v^T, so that
   *   a body may be given to it that nothing else holds; the internal forces of
   *   a solution are those of the body alone.
   */
  CondensedSolver(const ElasticModel<dim> &model,
                  std::shared_ptr<const Constraints> base,
                  const dealii::IndexSet &cut,
                  std::vector<UnknownForces> foundation = {});

  /** Go to a stage: see InterfaceSystem::set_constraints().
   *
   * @param stage closed: `base`, and ties among the interface unknowns. */
  bool
  set_constraints(std::shared_ptr<const Constraints> stage);

  /** Factor another tangent than that of the body at rest, at the present
   * stage: correction() is with it from here on. On one process.
   *
   * @throw NotDefiniteError where it is not positive definite; then the factor
   *   is that of the body at rest. */
  void
  linearize(const Linearization &linearization);

  /** See InterfaceSystem. */
  bool
  append_stage(const Constraints &stage);
  void
  factorize_stages();

  Solution
  solve(const LA::Vector &forces,
        const LA::Vector &lift,
        const LA::Vector &guess) override;

  /** The displacement under condensed forces in the present stage, without
   * iterative refinement. */
  LA::Vector
  correction(const LA::Vector &forces);

  /** The free unknowns of the interface in the present stage. */
  unsigned int
  n_free() const;

  /** What forces on the interface do to each other, in all stages that have
   * been factored. */
  struct Compliance
  {
    /** See InterfaceSystem::half_displacements(). The last column is that of
     * the loads. On the first process only. */
    dealii::LAPACKFullMatrix<double> half_displacements;
    /** The work of each of the forces in the lift. */
    std::vector<double> work_in_lift;

    /** Add the products of all columns over some rows, so that over the free
     * unknowns of a stage they are the work of one force in the displacement
     * under the other: the lower half of a symmetric matrix. On the first
     * process. */
    void
    add_products(const unsigned int begin,
                 const unsigned int end,
                 dealii::LAPACKFullMatrix<double> &products) const;
  };

  /**
   * @param on_interface forces on unknowns of the cut, the same on all
   *   processes; those that `base` constrains must be supported.
   * @param loads, lift as in solve(); the lift has no opening. */
  Compliance
  compliance(const std::vector<UnknownForces> &on_interface,
             const LA::Vector &loads,
             const LA::Vector &lift);

private:
  /** The state of the interface, and what the back substitution needs. */
  struct InterfaceState
  {
    std::vector<double> displacement;
    StaticCondensation::Eliminated loads;
  };

  /** Eliminate what is not on the cut. */
  void
  condense_onto_cut(const LA::SparseMatrix &matrix);

  /** The same of the stiffness of the body at rest. */
  void
  condense_at_rest();

  /** What body and foundation resist a displacement with. */
  LA::Vector
  resisting_forces(const LA::Vector &displacement) const;

  /** A vector, its unknowns by their places in the cut; what is not on it is
   * handed to a function instead. */
  UnknownForces
  placed_on_cut(const UnknownForces &vector,
                const std::function<void(unsigned int, double)> &beside) const;

  /** A vector's entries on the interface. */
  std::vector<double>
  on_cut(const LA::Vector &vector) const;

  /**
   * StaticCondensation::forward_eliminate(), or its result for the last loads
   * that are remembered, where these are the same but for those on the
   * interface.
   */
  StaticCondensation::Eliminated
  forward_eliminate(const LA::Vector &loads, const bool is_remembered);

  /**
   * Solve on the interface.
   *
   * @param b       forces, condensed by `base`.
   * @param opening the lift of the interface; nothing if it is zero.
   */
  InterfaceState
  solve_interface(const LA::Vector &b,
                  const std::vector<double> &opening,
                  const bool is_remembered);

  /** The displacement of the whole body. */
  LA::Vector
  recover(InterfaceState &&state) const;

  /** The forces less K times a lift off the cut. */
  LA::Vector
  residual_of_lift(const LA::Vector &forces, const LA::Vector &lift_off_cut);

  /**
   * Split a lift: its part on the interface is returned, nothing if it is zero,
   * and subtracted from it.
   */
  std::vector<double>
  take_opening(LA::Vector &lift) const;

  /** The quality of a solution.
   *
   * @throw SolverError where it is not good enough. */
  SolveQuality
  check_quality(const LA::Vector &x,
                const LA::Vector &residual,
                const double scale,
                const RefinedSystem &system);

  const ElasticModel<dim> &model;
  const std::shared_ptr<const Constraints> base;
  const std::vector<UnknownForces> foundation;
  const MPI_Comm communicator;
  const bool is_first;
  std::shared_ptr<const Constraints> constraints;
  /** The interface unknowns that `base` leaves free, ascending. */
  std::vector<unsigned int> cut;
  /** On the first process, as the next. */
  std::unique_ptr<StaticCondensation> condensation;
  std::unique_ptr<InterfaceSystem> interface;
  /** The largest sum of a row of the stiffness. */
  double largest_entry = 0;
  /** The last lift off the cut, and K times it. */
  LA::Vector remembered_lift, forces_of_lift;
  LA::Vector remembered_loads;
  StaticCondensation::Eliminated remembered;
  /** The displacement for a residual of 1, and the largest displacement for
   * loads of size 1, when the quality was last looked at closely. */
  double per_residual = 0, known_compliance = 0;
};
} // namespace Setsudan
