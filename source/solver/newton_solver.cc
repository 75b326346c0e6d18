// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mechanics/stress/deformation_extremes.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/solver/condensed/condensed_solver.h>
#include <setsudan/solver/newton_path.h>
#include <setsudan/solver/newton_solver.h>
#include <setsudan/solver/no_equilibrium.h>

#include <optional>

namespace Setsudan
{
using namespace dealii;

namespace
{
/**
 * Go on from one part of a way to another, with the one tangent or the other;
 * nothing where neither leads to a state that a body can be in.
 *
 * @param failure of a linear solve that was in the way of the exact tangent; is
 *   set.
 */
template <int dim>
std::optional<NewtonIterate>
try_part(const ElasticModel<dim> &model,
         NewtonPath<dim> &path,
         const NewtonIterate &from,
         const double part_of_from,
         const double part,
         std::optional<SolverError> &failure)
{
  using Tangent = typename NewtonPath<dim>::Tangent;
  std::optional<NewtonIterate> reached;
  for (const auto tangent : {Tangent::extrapolated, Tangent::exact})
    if (succeeds(
          [&] {
            reached = path.go(from, part_of_from, part, tangent);
            return reached &&
                   (!model.materials.finite_strain ||
                    is_attainable(
                      model, from.displacement, reached->displacement));
          },
          failure))
      return reached;
  return {};
}
} // namespace


template <int dim>
NewtonSolver<dim>::NewtonSolver(const ElasticModel<dim> &model,
                                std::shared_ptr<const Constraints> constraints,
                                const SolverParameters &parameters,
                                std::shared_ptr<CondensedSolver<dim>> factor)
  : model(model)
  , constraints(std::move(constraints))
  , parameters(parameters)
  , factor(std::move(factor))
{
}



template <int dim>
Solution
NewtonSolver<dim>::solve(const LA::Vector &forces,
                         const LA::Vector &lift,
                         const LA::Vector &start)
{
  NewtonPath<dim> path(
    model,
    *constraints,
    parameters,
    forces,
    lift,
    start,
    factor && factor->set_constraints(constraints) ? factor : nullptr);
  NewtonIterate last   = path.beginning();
  unsigned int n_steps = 0;
  std::optional<SolverError> failure;
  const double reached = follow_in_parts(
    [&](const double behind, const double part) -> std::optional<unsigned int> {
      auto next = try_part(model, path, last, behind, part, failure);
      if (!next)
        return {};
      last = std::move(*next);
      n_steps += last.n_steps;
      return last.n_steps;
    });
  if (reached < 1)
    {
      if (failure)
        throw *failure;
      throw_no_equilibrium(
        model, *constraints, parameters, last.displacement, reached);
    }
  path.quality.residual    = last.relative_residual;
  path.quality.force_scale = path.size_of_first_forces();
  return {std::move(last.displacement),
          std::move(last.internal.forces),
          path.quality,
          n_steps};
}



template class NewtonSolver<2>;
template class NewtonSolver<3>;
} // namespace Setsudan
