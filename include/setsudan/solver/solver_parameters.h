#pragma once

#include <deal.II/base/types.h>

#include <setsudan/parameters/parameters.h>

namespace Setsudan
{
/** Subsection `Solver`: how the systems of equations are solved. */
struct SolverParameters
{
  enum class Method
  {
    automatic,
    direct,
    iterative
  };

  /** Whether a body of so many unknowns is to be solved directly. */
  bool
  is_direct(const dealii::types::global_dof_index n_unknowns) const;

  Method method;
  unsigned int direct_up_to;
  double tolerance;
  unsigned int max_iterations;

  static void
  declare(dealii::ParameterHandler &handler);

  explicit SolverParameters(const Parameters &parameters);
};
} // namespace Setsudan
