#pragma once

#include <deal.II/lac/affine_constraints.h>

#include <setsudan/solver/condensed/incremental_cholesky.h>
#include <setsudan/solver/condensed/schur_complement.h>

#include <utility>
#include <vector>

namespace Setsudan
{
/**
 * The unknowns of a cut whose ties are taken off step by step.
 *
 * In each step the unknowns u are combinations Q q of those which the ties
 * leave free, and Q^T S Q is factored, where S is their stiffness. Taking off
 * ties adds columns to Q and leaves the others as they are: the factor of an
 * earlier step is a leading block of that of a later one. So the factor grows
 * from step to step and is never made anew; and if the steps are known
 * beforehand it is made at once. A step costs as many operations as it has new
 * unknowns, times the square of those there are.
 */
class InterfaceSystem
{
public:
  using Constraints = dealii::AffineConstraints<double>;

  /** @param unknowns ascending, as many as `stiffness` has. */
  InterfaceSystem(const std::vector<unsigned int> &unknowns,
                  const SchurComplement &stiffness);

  /**
   * Go to a step. What the last step has and this one does not forbid is kept,
   * so that it takes least where ties are only taken off, or put on again in
   * the opposite order.
   *
   * @param step closed, with ties among the unknowns of the cut.
   * @return false where a tie leads out of the cut, and nothing has changed.
   * @throw SolverError where the stiffness is not definite.
   */
  bool
  set_constraints(const Constraints &step);

  /** Remember a step for activate_stage(). Steps that are foreseen must be so
   * in their order, and are forgotten where set_constraints() does not agree
   * with them.
   *
   * @return false where a tie leads out of the cut, and nothing has changed. */
  bool
  append_stage(const Constraints &step);

  /** Factor all that is foreseen at once. */
  void
  factorize_foreseen();

  /** Go to a step that has been foreseen, counted from 0.
   *
   * @return false where there is none, and nothing has changed. */
  bool
  activate_stage(const unsigned int step);

  /** The displacement Q (Q^T S Q)^-1 Q^T f of the cut under forces f on it. */
  std::vector<double>
  displacement(const double *forces) const;

private:
  /** A column of Q: unknowns, by their place in the cut, and factors. */
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

  /** Make the columns of a step the first ones. */
  bool
  place(const Constraints &step);

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
  /** How many of the columns belong to the present step, and to those that have
   * been foreseen. */
  unsigned int n_columns = 0;
  std::vector<unsigned int> n_columns_of;
};
} // namespace Setsudan
