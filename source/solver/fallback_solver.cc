#include <setsudan/solver/assembled_solver.h>
#include <setsudan/solver/fallback_solver.h>
#include <setsudan/solver/matrix_free_solver.h>

namespace Setsudan
{
using namespace dealii;

namespace
{
// The factor of a larger body takes more memory than a machine is likely to
// have.
constexpr types::global_dof_index most_direct_unknowns = 400000;
} // namespace


template <int dim>
FallbackSolver<dim>::FallbackSolver(ElasticModel<dim> &model,
                                    std::shared_ptr<const Constraints> held,
                                    const SolverParameters &parameters,
                                    const bool has_fallen_back,
                                    const FallbackSolver<dim> *last)
  : model(model)
  , constraints(std::move(held))
  , parameters(parameters)
  , fell_back(has_fallen_back)
{
  if (!fell_back && is_matrix_free(model, parameters))
    multigrid = std::make_unique<MatrixFreeSolver<dim>>(
      model,
      *constraints,
      parameters,
      last != nullptr ? last->multigrid.get() : nullptr);
  else
    assemble();
}



template <int dim>
FallbackSolver<dim>::~FallbackSolver() = default;


template <int dim>
bool
FallbackSolver<dim>::is_matrix_free(const ElasticModel<dim> &model,
                                    const SolverParameters &parameters)
{
  return !parameters.is_direct(model.discretization.dof_handler.n_dofs()) &&
         model.discretization.type != ElementType::linear;
}



template <int dim>
void
FallbackSolver<dim>::assemble()
{
  if (fell_back &&
      model.discretization.dof_handler.n_dofs() <= most_direct_unknowns)
    parameters.method = SolverParameters::Method::direct;
  assembled =
    std::make_unique<AssembledSolver<dim>>(model, *constraints, parameters);
}



template <int dim>
LA::Vector
FallbackSolver<dim>::solve(const LA::Vector &forces,
                           const LA::Vector &prescribed,
                           const LA::Vector &guess)
{
  if (multigrid)
    try
      {
        const LA::Vector x = multigrid->solve(forces, prescribed, guess);
        quality            = multigrid->quality_of_last();
        return x;
      }
    catch (const SolverError &error)
      {
        multigrid.reset();
        fell_back = true;
        assemble();
        failure = std::string(error.what()) + " From here on the solver is " +
                  assembled->description() + ".";
      }
  const LA::Vector x = assembled->solve(forces, prescribed, guess);
  quality            = assembled->quality_of_last();
  quality.warning    = failure;
  failure.clear();
  return x;
}



template <int dim>
SolveQuality
FallbackSolver<dim>::quality_of_last() const
{
  return quality;
}



template <int dim>
bool
FallbackSolver<dim>::has_fallen_back() const
{
  return fell_back;
}



template <int dim>
std::string
FallbackSolver<dim>::description(const ElasticModel<dim> &model,
                                 const SolverParameters &parameters)
{
  if (is_matrix_free(model, parameters))
    return "iterative (conjugate gradients with multigrid, without a matrix)";
  return make_linear_solver(parameters,
                            model.discretization.dof_handler.n_dofs(),
                            model.discretization.communicator)
    ->description();
}



template class FallbackSolver<2>;
template class FallbackSolver<3>;
} // namespace Setsudan
