// SPDX-License-Identifier: LGPL-2.1-or-later
// A small elastic body with its displacement under its loads, by the solver
// that its assignments ask for.
#pragma once

#include <setsudan/solver/assembled_solver.h>

#include "small_model.h"

namespace Setsudan
{
template <int dim>
struct SolvedModel : SmallModel<dim>
{
  static void
  declare(dealii::ParameterHandler &handler)
  {
    SmallModel<dim>::declare(handler);
    SolverParameters::declare(handler);
  }

  explicit SolvedModel(const Parameters &parameters,
                       const Refinement &refinement = {})
    : SmallModel<dim>(parameters, nullptr, refinement)
    , solver_parameters(parameters)
    , displacement(solve())
  {
  }

  /** On the elements of `mesh`. */
  SolvedModel(const Parameters &parameters,
              const CoarseMesh<dim> &mesh,
              const Refinement &refinement = {})
    : SmallModel<dim>(parameters, &mesh, refinement)
    , solver_parameters(parameters)
    , displacement(solve())
  {
  }

  explicit SolvedModel(const Assignments &assignments,
                       const Refinement &refinement = {})
    : SolvedModel(parameters_of(assignments, declare), refinement)
  {
  }

  const SolverParameters solver_parameters;
  const LA::Vector displacement;

private:
  LA::Vector
  solve()
  {
    using Constraints = dealii::AffineConstraints<double>;
    auto &model       = this->model;
    Constraints constraints(model.discretization.relevant);
    constraints.merge(model.hanging);
    constraints.merge(model.supports);
    constraints.close();
    return AssembledSolver<dim>(
             model,
             constraints,
             solver_parameters,
             choose_assembled(solver_parameters, size_of(model.discretization)))
      .solve(model.loads, model.lift, model.discretization.zero_vector())
      .displacement;
  }
};
} // namespace Setsudan
