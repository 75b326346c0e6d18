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
bool
CutBody<dim>::is_condensed() const
{
  using Solve = DivisionParameters::Solve;
  if (scene.division.solve == Solve::anew || seams.empty() ||
      seam().n_double_pairs() == 0 || !seam().holds() ||
      Utilities::MPI::n_mpi_processes(communicator) > 1)
    return false;
  if (scene.division.solve == Solve::condensed)
    return true;
  return scene.solver.method != SolverParameters::Method::iterative &&
         seam().rows().size() >= fewest_rows &&
         model->discretization.dof_handler.n_dofs() <= most_unknowns &&
         CondensedEquilibrium<dim>::memory(2 * dim * seam().n_double_pairs()) <=
           most_memory;
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
  if (is_condensed())
    {
      if (!condensed)
        condensed = std::make_shared<CondensedEquilibrium<dim>>(
          *model,
          std::make_shared<const AffineConstraints<double>>(base_constraints()),
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
