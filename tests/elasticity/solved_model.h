// A small elastic body with its displacement under its loads, by the solver
// that its assignments ask for.
#pragma once

#include <setsudan/solver/equilibrium.h>

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

  explicit SolvedModel(const Parameters &parameters)
    : SmallModel<dim>(parameters, nullptr)
    , solver_parameters(parameters)
    , displacement(solve())
  {
  }

  explicit SolvedModel(const Assignments &assignments)
    : SolvedModel(parameters_of(assignments, declare))
  {
  }

  const SolverParameters solver_parameters;
  const LA::Vector displacement;

private:
  LA::Vector
  solve()
  {
    auto &model           = this->model;
    const LA::Vector zero = model.discretization.zero_vector();
    return Equilibrium<dim>(model, model.supports, solver_parameters)
      .solve(model.loads, zero, zero);
  }
};
} // namespace Setsudan
