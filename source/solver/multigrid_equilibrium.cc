#include <deal.II/lac/solver_cg.h>

#include <setsudan/solver/linear_solver.h>
#include <setsudan/solver/multigrid_equilibrium.h>
#include <setsudan/solver/p_multigrid.h>

#include <algorithm>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
// Where more are needed other solvers take less time.
constexpr unsigned int most_iterations = 500;
} // namespace


template <int dim>
MultigridEquilibrium<dim>::MultigridEquilibrium(
  ElasticModel<dim> &model,
  const AffineConstraints<double> &constraints,
  const SolverParameters &parameters)
  : ConstrainedEquilibrium<dim>(model, constraints, parameters)
  , max_iterations(std::min(parameters.max_iterations, most_iterations))
  , tolerance(parameters.tolerance)
{
  model.batches().know(constraints.get_local_lines());
  const auto &batches = model.batches();
  lines               = std::make_unique<const ConstraintLines>(constraints,
                                                  *batches.partitioner());
  stiffness           = std::make_unique<const ConstrainedStiffness<dim>>(
    model.discretization, batches, *lines);
  multigrid =
    std::make_unique<const PMultigrid<dim>>(model, constraints, *stiffness);
}



template <int dim>
MultigridEquilibrium<dim>::~MultigridEquilibrium() = default;


template <int dim>
LA::Vector
MultigridEquilibrium<dim>::solve_condensed(const LA::Vector &loads,
                                           const LA::Vector &guess)
{
  const double scale = loads.l2_norm();
  check_loads(scale);
  const auto &batches = stiffness->batches;
  const Vector b      = batches.imported(loads);
  Vector x            = batches.imported(guess);
  iterations          = 0;
  if (scale > 0)
    iterate(x, b);
  else
    x = 0;

  Vector rest(b), correction(b);
  stiffness->vmult(rest, x);
  rest.sadd(-1., 1., b);
  multigrid->vmult(correction, rest);
  const LA::Vector result = batches.exported(x);
  quality =
    quality_of(result, batches.exported(correction), rest.l2_norm(), scale);
  if (!(quality.residual <= accepted))
    fail();
  return result;
}



template <int dim>
void
MultigridEquilibrium<dim>::iterate(Vector &x, const Vector &b)
{
  SolverControl control(max_iterations, tolerance * b.l2_norm());
  try
    {
      SolverCG<Vector>(control).solve(*stiffness, x, b, *multigrid);
    }
  catch (const SolverControl::NoConvergence &)
    {
      // The true residual decides.
    }
  iterations = control.last_step();
}



template <int dim>
void
MultigridEquilibrium<dim>::fail() const
{
  std::ostringstream message;
  message << "Conjugate gradients with multigrid left a relative residual of "
          << quality.residual << " after " << iterations << " iterations.";
  throw SolverError(message.str());
}



template <int dim>
unsigned int
MultigridEquilibrium<dim>::n_iterations() const
{
  return iterations;
}



template class MultigridEquilibrium<2>;
template class MultigridEquilibrium<3>;
} // namespace Setsudan
