#include <deal.II/base/mpi.h>

#include <setsudan/simulation/cut_body.h>
#include <setsudan/solver/equilibrium.h>

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


/** The equilibrium for one set of constraints, which it owns. */
template <int dim>
struct OwnEquilibrium
{
  OwnEquilibrium(ElasticModel<dim> &model,
                 std::shared_ptr<const AffineConstraints<double>> held,
                 const SolverParameters &parameters)
    : constraints(std::move(held))
    , equilibrium(model, *constraints, parameters)
  {
  }

  const std::shared_ptr<const AffineConstraints<double>> constraints;
  Equilibrium<dim> equilibrium;
};
} // namespace


template <int dim>
std::string
CutBody<dim>::why_anew() const
{
  using Solve = DivisionParameters::Solve;
  if (has_single_states || seams.empty() || seam().n_double_pairs() == 0 ||
      !seam().holds())
    return "there is no seam";
  if (scene.division.solve == Solve::anew)
    return "as Division/Solve says";
  if (Utilities::MPI::n_mpi_processes(communicator) > 1)
    return "since there are several processes";
  if (scene.division.solve == Solve::condensed)
    return "";
  if (scene.solver.method == SolverParameters::Method::iterative)
    return "since Solver/Method is iterative";
  if (seam().rows().size() < fewest_rows)
    return "since there are few rows";
  if (model->discretization.dof_handler.n_dofs() > most_unknowns)
    return "since there are more than " + std::to_string(most_unknowns) +
           " unknowns";
  if (CondensedEquilibrium<dim>::memory(2 * dim * seam().n_double_pairs()) >
      most_memory)
    return "since the cut has too many unknowns for the memory";
  return "";
}



template <int dim>
bool
CutBody<dim>::is_condensed() const
{
  return why_anew().empty();
}



template <int dim>
void
CutBody<dim>::expect_single_states()
{
  has_single_states = true;
}



template <int dim>
std::shared_ptr<EquilibriumSolver>
CutBody<dim>::equilibrium()
{
  return equilibrium_under(constraints());
}



template <int dim>
std::shared_ptr<EquilibriumSolver>
CutBody<dim>::equilibrium_under(AffineConstraints<double> &&present)
{
  const auto held =
    std::make_shared<const AffineConstraints<double>>(std::move(present));
  // The pieces, in the end, are one step more of what there is.
  if (condensed || is_condensed())
    {
      if (!condensed)
        condensed = std::make_shared<CondensedEquilibrium<dim>>(
          *model,
          std::make_shared<const AffineConstraints<double>>(
            constraints_of(seams.size() - 1)),
          seam().coupled_indices(model->discretization.dof_handler.n_dofs()));
      if (condensed->set_constraints(held))
        return condensed;
      condensed.reset();
    }
  const auto own =
    std::make_shared<OwnEquilibrium<dim>>(*model, held, scene.solver);
  return {own, &own->equilibrium};
}



template class CutBody<2>;
template class CutBody<3>;
} // namespace Setsudan
