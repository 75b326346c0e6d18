// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/assembled_solver.h>
#include <setsudan/solver/fallback_solver.h>
#include <setsudan/solver/matrix_free_solver.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
FallbackSolver<dim>::FallbackSolver(const ElasticModel<dim> &model,
                                    std::shared_ptr<const Constraints> held,
                                    const SolverParameters &parameters,
                                    const SolverKind kind,
                                    const FallbackSolver<dim> *last)
  : model(model)
  , constraints(std::move(held))
  , parameters(parameters)
{
  if (kind == SolverKind::matrix_free)
    multigrid = std::make_unique<MatrixFreeSolver<dim>>(
      model,
      *constraints,
      parameters,
      last != nullptr ? last->multigrid.get() : nullptr);
  else
    assemble(kind);
}



template <int dim>
FallbackSolver<dim>::~FallbackSolver() = default;


template <int dim>
void
FallbackSolver<dim>::assemble(const SolverKind kind)
{
  assembled = std::make_unique<AssembledSolver<dim>>(
    model, *constraints, parameters, kind);
}



template <int dim>
Solution
FallbackSolver<dim>::solve(const LA::Vector &forces,
                           const LA::Vector &lift,
                           const LA::Vector &guess)
{
  if (!multigrid)
    return assembled->solve(forces, lift, guess);
  try
    {
      return multigrid->solve(forces, lift, guess);
    }
  catch (const SolverError &error)
    {
      multigrid.reset();
      fell_back             = true;
      const SolverKind kind = choose_fallback(size_of(model.discretization));
      assemble(kind);
      Solution solution        = assembled->solve(forces, lift, guess);
      solution.quality.warning = std::string(error.what()) +
                                 " From here on the solver is " +
                                 description(kind) + ".";
      return solution;
    }
}



template <int dim>
bool
FallbackSolver<dim>::has_fallen_back() const
{
  return fell_back;
}



template class FallbackSolver<2>;
template class FallbackSolver<3>;
} // namespace Setsudan
