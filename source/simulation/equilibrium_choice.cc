#include <deal.II/base/mpi.h>

#include <setsudan/simulation/equilibrium_choice.h>
#include <setsudan/solver/condensed/condensed_solver.h>
#include <setsudan/solver/fallback_solver.h>

namespace Setsudan
{
using namespace dealii;

namespace
{
// What is condensed may take this much memory besides the factor, and the
// factor of a body of more unknowns takes more than a few solves by iterations.
constexpr double most_memory         = 4e9;
constexpr unsigned int most_unknowns = 200000;
// With fewer rows the second factorization does not pay.
constexpr unsigned int fewest_rows = 3;
} // namespace


template <int dim>
EquilibriumChoice<dim>::EquilibriumChoice(const Scene<dim> &scene)
  : scene(scene)
{
}



template <int dim>
void
EquilibriumChoice<dim>::expect_single_states()
{
  has_single_states = true;
}



template <int dim>
void
EquilibriumChoice<dim>::forget()
{
  condensed.reset();
  learn_from_ladder();
  ladder.reset();
}



template <int dim>
void
EquilibriumChoice<dim>::learn_from_ladder()
{
  has_fallen_back = has_fallen_back || (ladder && ladder->has_fallen_back());
}



template <int dim>
std::string
EquilibriumChoice<dim>::why_anew(const ElasticModel<dim> &model,
                                 const Seam<dim> *seam) const
{
  using Solve                = DivisionParameters::Solve;
  const auto &discretization = model.discretization;
  if (has_single_states || seam == nullptr || seam->n_double_pairs() == 0 ||
      !seam->holds())
    return "there is no seam";
  if (scene.division.solve == Solve::anew ||
      scene.division.solve == Solve::iterative)
    return "as Division/Solve says";
  if (Utilities::MPI::n_mpi_processes(discretization.communicator) > 1)
    return "since there are several processes";
  if (scene.division.solve != Solve::automatic)
    return "";
  if (scene.solver.method == SolverParameters::Method::iterative)
    return "since Solver/Method is iterative";
  if (seam->rows().size() < fewest_rows)
    return "since there are few rows";
  if (discretization.dof_handler.n_dofs() > most_unknowns)
    return "since there are more than " + std::to_string(most_unknowns) +
           " unknowns";
  if (CondensedSolver<dim>::memory(2 * dim * seam->n_double_pairs()) >
      most_memory)
    return "since the cut has too many unknowns for the memory";
  return "";
}



template <int dim>
bool
EquilibriumChoice<dim>::is_foreseen(const bool all_held) const
{
  using Solve = DivisionParameters::Solve;
  using Check = YieldParameters::Check;
  // Where a piece comes loose the constraints change by more than a row.
  if (!all_held || scene.division.solve == Solve::condensed)
    return false;
  return scene.division.solve == Solve::one_factorization ||
         (scene.yield.check == Check::once && !scene.yield.needs_seam());
}



template <int dim>
void
EquilibriumChoice<dim>::condense(ElasticModel<dim> &model,
                                 const Seam<dim> &seam,
                                 const bool all_held,
                                 const OtherStates &others)
{
  condensed = std::make_shared<CondensedSolver<dim>>(
    model,
    std::make_shared<const Constraints>(others.without_seam()),
    seam.coupled_indices(model.discretization.dof_handler.n_dofs()));
  if (!is_foreseen(all_held))
    return;
  others.for_each_row(
    [&](const Constraints &later) { condensed->append_stage(later); });
  condensed->factorize_foreseen();
}



template <int dim>
std::shared_ptr<CondensedSolver<dim>>
EquilibriumChoice<dim>::all_states(ElasticModel<dim> &model,
                                   const Seam<dim> *seam,
                                   const bool all_held,
                                   const OtherStates &others)
{
  // The pieces, in the end, are one step more of what there is.
  if (!condensed && why_anew(model, seam).empty())
    condense(model, *seam, all_held, others);
  return condensed;
}



template <int dim>
std::shared_ptr<TangentSolver>
EquilibriumChoice<dim>::solver(ElasticModel<dim> &model,
                               const Seam<dim> *seam,
                               const unsigned int n_split_rows,
                               Constraints &&constraints,
                               const bool all_held,
                               const OtherStates &others)
{
  const auto held = std::make_shared<const Constraints>(std::move(constraints));
  if (all_states(model, seam, all_held, others) &&
      condensed->set_constraints(held))
    return condensed;
  condensed.reset();
  learn_from_ladder();
  const bool keeps = n_split_rows % rows_per_preparation != 0;
  ladder           = std::make_shared<FallbackSolver<dim>>(
    model, held, scene.solver, has_fallen_back, keeps ? ladder.get() : nullptr);
  return ladder;
}



template class EquilibriumChoice<2>;
template class EquilibriumChoice<3>;
} // namespace Setsudan
