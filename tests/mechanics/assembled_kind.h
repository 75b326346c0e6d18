// SPDX-License-Identifier: LGPL-2.1-or-later
// The solver that parameters ask for, or its like with an assembled matrix.
#pragma once

#include <setsudan/solver/solver_choice.h>

namespace Setsudan
{
template <int dim>
SolverKind
assembled_kind(const SolverParameters &parameters,
               const Discretization<dim> &discretization)
{
  SystemSize size   = size_of(discretization);
  size.element_type = ElementType::linear;
  return choose_solver(parameters, size).kind;
}
} // namespace Setsudan
