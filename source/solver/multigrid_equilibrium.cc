#include <deal.II/lac/solver_cg.h>

#include <setsudan/solver/linear/linear_solver.h>
#include <setsudan/solver/multigrid/p_multigrid.h>
#include <setsudan/solver/multigrid_equilibrium.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <utility>

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
  const SolverParameters &parameters,
  const MultigridEquilibrium<dim> *last)
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
  if (last != nullptr && last->coarse->obeys(*lines, batches))
    coarse = last->coarse;
  else
    coarse =
      std::make_shared<const CoarseCorrection<dim>>(model, constraints, *lines);
  multigrid = std::make_unique<const PMultigrid<dim>>(*stiffness, coarse);
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
  Vector rest(b), correction(b);
  iterations = 0;
  if (scale > 0)
    iterate(x, b, rest);
  else
    x = rest = 0;

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
MultigridEquilibrium<dim>::iterate(Vector &x, const Vector &b, Vector &rest)
{
  // Where cells are slender, many iterations take for solved what is not.
  const double scale = b.l2_norm();
  double error       = std::numeric_limits<double>::max();
  bool goes_on       = true;
  while (goes_on)
    {
      SolverControl control(max_iterations - iterations, tolerance * scale);
      try
        {
          SolverCG<Vector>(control).solve(*stiffness, x, b, *multigrid);
        }
      catch (const SolverControl::NoConvergence &)
        {
          // The true residual decides.
        }
      iterations += control.last_step();
      stiffness->vmult(rest, x);
      rest.sadd(-1., 1., b);
      const double last = std::exchange(error, rest.l2_norm());
      goes_on           = iterations < max_iterations && error < last / 2 &&
                error > accepted * scale;
    }
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
