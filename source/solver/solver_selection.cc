// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/condensed/condensed_solver.h>
#include <setsudan/solver/fallback_solver.h>
#include <setsudan/solver/newton_solver.h>
#include <setsudan/solver/solver_selection.h>

namespace Setsudan
{
namespace
{
// So many states in turn are solved with one coarse correction of multigrid.
// Each takes two iterations more than the one before, and has it for nothing.
constexpr unsigned int states_per_coarse_correction = 4;
} // namespace


template <int dim>
SolverSelection<dim>::SolverSelection(const SolverParameters &parameters)
  : parameters(parameters)
{
}



template <int dim>
void
SolverSelection<dim>::forget()
{
  condensed.reset();
  learn();
  single.reset();
  ++forgotten;
}



template <int dim>
void
SolverSelection<dim>::learn()
{
  has_fallen_back = has_fallen_back || (single && single->has_fallen_back());
}



template <int dim>
Choice<SolverKind>
SolverSelection<dim>::choice(const ElasticModel<dim> &model) const
{
  const SystemSize size = size_of(model.discretization);
  if (!model.is_linear())
    return {choose_tangent_solver(model, parameters),
            "in each step of Newton's method, " +
              choose_solver(parameters, size).reason};
  const auto chosen = choose_solver(parameters, size);
  if (chosen.kind == SolverKind::matrix_free && !model.materials.is_hookean())
    return {choose_assembled(parameters, size),
            "since all ways without a matrix are for isotropic materials"};
  if (chosen.kind == SolverKind::matrix_free && has_fallen_back)
    return {choose_fallback(size), "since multigrid has failed"};
  return chosen;
}



template <int dim>
std::shared_ptr<CondensedSolver<dim>>
SolverSelection<dim>::condense(const ElasticModel<dim> &model,
                               const CutStages &stages) const
{
  auto solver = std::make_shared<CondensedSolver<dim>>(
    model,
    std::make_shared<const Constraints>(stages.without_ties()),
    stages.interface_unknowns(),
    stages.foundation());
  if (stages.are_known)
    {
      for (unsigned int n_split = 0; n_split <= stages.n_rows; ++n_split)
        solver->append_stage(stages.after(n_split));
      solver->factorize_stages();
    }
  return solver;
}



template <int dim>
std::shared_ptr<TangentSolver>
SolverSelection<dim>::solver(const ElasticModel<dim> &model,
                             std::shared_ptr<const Constraints> constraints,
                             const CutStages *stages)
{
  if (stages != nullptr && !condensed)
    condensed = condense(model, *stages);
  if (!model.is_linear())
    return std::make_shared<NewtonSolver<dim>>(
      model, std::move(constraints), parameters, condensed);
  if (condensed && condensed->set_constraints(constraints))
    return condensed;
  condensed.reset();
  learn();
  const bool keeps = single && n_reused + 1 < states_per_coarse_correction;
  n_reused         = keeps ? n_reused + 1 : 0;
  single =
    std::make_shared<FallbackSolver<dim>>(model,
                                          std::move(constraints),
                                          parameters,
                                          choice(model).kind,
                                          keeps ? single.get() : nullptr);
  return single;
}



template class SolverSelection<2>;
template class SolverSelection<3>;
} // namespace Setsudan
