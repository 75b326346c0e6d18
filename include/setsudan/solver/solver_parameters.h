#pragma once

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

  Method method;
  unsigned int direct_up_to;
  double tolerance;
  unsigned int max_iterations;

  static void
  declare(dealii::ParameterHandler &handler);

  explicit SolverParameters(const Parameters &parameters);
};
} // namespace Setsudan
