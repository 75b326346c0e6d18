// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/affine_constraints.h>

#include <setsudan/solver/condensed/incremental_cholesky.h>
#include <setsudan/solver/condensed/schur_complement.h>
#include <setsudan/solver/condensed/unknown_forces.h>

#include <utility>
#include <vector>

namespace Setsudan
{
/**
 * The equilibrium of the interface, the unknowns of a cut, under ties that are
 * taken off stage by stage.
 *
 * In each stage the unknowns u are combinations Q q of those which the ties
 * leave free, and Q^T S Q is factored, where S is their Schur complement.
 * Taking off ties adds columns to Q and leaves the others as they are: the
 * factor of an earlier stage is a leading block of that of a later one. So the
 * factor grows from stage to stage and is never made anew; and if the stages
 * are known beforehand it is made at once. A stage costs as many operations as
 * it has new unknowns, times the square of those there are.
 */
class InterfaceSystem
{
public:
  using Constraints = dealii::AffineConstraints<double>;

  /** @param unknowns ascending, as many as `stiffness` has. */
  InterfaceSystem(const std::vector<unsigned int> &unknowns,
                  const SchurComplement &stiffness);

  /**
   * Go to a stage. What the last one has and this one does not forbid is kept,
   * so that it takes least where ties are only taken off, or put on again in
   * the opposite order.
   *
   * @param stage closed, with ties among the interface unknowns.
   * @return false where a tie leads out of the interface, and nothing has
   *   changed.
   * @throw SolverError where the stiffness is not definite.
   */
  bool
  set_constraints(const Constraints &stage);

  /** Remember a stage that will follow those before, for factorize_stages().
   *
   * @return as set_constraints(). */
  bool
  append_stage(const Constraints &stage);

  /** Factor all stages that are remembered at once. */
  void
  factorize_stages();

  /** The displacement Q (Q^T S Q)^-1 Q^T f of the cut under forces f on it, in
   * the present stage. */
  std::vector<double>
  displacement(const double *forces) const;

  /** How many unknowns are free in the present stage: these are the first ones
   * of all. */
  unsigned int
  n_free() const
  {
    return n_columns;
  }

  /**
   * The vectors y = L^-1 Q^T f of forces f, where L is the factor of all stages
   * up to the last one: over the free unknowns of a stage, the product of two
   * of them is the work of one force in the displacement under the other.
   *
   * @param forces each on all unknowns of the interface.
   * @return a column for each, with a row for each free unknown.
   */
  dealii::LAPACKFullMatrix<double>
  half_displacements(const std::vector<UnknownForces> &forces) const;

private:
  /** A column of Q: unknowns, by their place in the cut, and factors. */
  using Column = std::vector<std::pair<unsigned int, double>>;

  /** The columns of a stage's free unknowns, in the order of the cut; nothing
   * where a tie leads out of the cut. */
  bool
  columns_of(const Constraints &stage,
             std::vector<unsigned int> &free,
             std::vector<Column> &columns) const;

  /** How many of the columns of Q, from the first, obey the ties of a stage. */
  unsigned int
  n_that_fit(const std::vector<unsigned int> &free,
             const std::vector<Column> &columns) const;

  /** Make the columns of a stage the first ones. */
  bool
  place(const Constraints &stage);

  /** Factor the first columns. */
  void
  factorize(const unsigned int n);

  const std::vector<unsigned int> unknowns;
  const SchurComplement &stiffness;
  /** Of all columns, or of the first ones. */
  IncrementalCholesky factor;
  /** The free unknown of each column. */
  std::vector<unsigned int> free_unknowns;
  std::vector<Column> basis;
  /** How many of the columns belong to the present stage. */
  unsigned int n_columns = 0;
};
} // namespace Setsudan
