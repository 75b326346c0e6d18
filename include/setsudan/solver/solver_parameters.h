// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/types.h>

#include <setsudan/parameters/parameters.h>

namespace Setsudan
{
/** Subsection `Solver`, and of `Division` how the states of a cut are solved:
 * what the user asks for. What is taken is chosen by choose_solver() and
 * choose_cut_strategy(). */
struct SolverParameters
{
  enum class Method
  {
    automatic,
    direct,
    iterative
  };

  enum class CutSolve
  {
    automatic,
    condensed,
    row_by_row
  };

  /** Whether a body of so many unknowns is to be solved directly. */
  bool
  is_direct(const dealii::types::global_dof_index n_unknowns) const;

  Method method;
  unsigned int direct_up_to;
  double tolerance;
  unsigned int max_iterations;
  CutSolve cut_solve;

  static void
  declare(dealii::ParameterHandler &handler);

  explicit SolverParameters(const Parameters &parameters);
};
} // namespace Setsudan
