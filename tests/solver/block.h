// SPDX-License-Identifier: LGPL-2.1-or-later
// A body with the solver of its scene and the constraints of its supports.
#pragma once

#include <setsudan/solver/newton_solver.h>

#include <memory>

#include "../mechanics/many_models.h"

namespace Setsudan
{
using namespace dealii;

struct Block : SmallModel<3>
{
  using Constraints = AffineConstraints<double>;

  static void
  declare(ParameterHandler &handler)
  {
    SmallModel<3>::declare(handler);
    SolverParameters::declare(handler);
  }

  explicit Block(const Assignments &assignments)
    : Block(parameters_of(assignments, declare))
  {
  }

  explicit Block(const Parameters &parameters)
    : SmallModel<3>(parameters, nullptr)
    , solver(parameters)
    , constraints(std::make_shared<Constraints>(model.discretization.relevant))
  {
    constraints->merge(model.supports);
    constraints->close();
  }

  Solution
  solve() const
  {
    return NewtonSolver<3>(model, constraints, solver)
      .solve(model.loads, model.lift, model.discretization.zero_vector());
  }

  const SolverParameters solver;
  std::shared_ptr<Constraints> constraints;
};
} // namespace Setsudan
