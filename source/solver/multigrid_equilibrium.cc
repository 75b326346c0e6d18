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
  : constraints(constraints)
  , parameters(parameters)
  , model(model)
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
typename MultigridEquilibrium<dim>::Vector
MultigridEquilibrium<dim>::imported(const LA::Vector &vector) const
{
  Vector copy(stiffness->batches.partitioner());
  const double *const values = vector.trilinos_vector()[0];
  std::copy(values, values + copy.locally_owned_size(), copy.begin());
  return copy;
}



template <int dim>
LA::Vector
MultigridEquilibrium<dim>::exported(const Vector &vector) const
{
  LA::Vector copy = model.discretization.zero_vector();
  std::copy(vector.begin(),
            vector.begin() + vector.locally_owned_size(),
            copy.trilinos_vector()[0]);
  return copy;
}



template <int dim>
typename MultigridEquilibrium<dim>::Vector
MultigridEquilibrium<dim>::loads_beside(const LA::Vector &forces,
                                        const LA::Vector &prescribed) const
{
  Vector held = imported(prescribed), loads(held);
  loads       = 0;
  held.update_ghost_values();
  stiffness->batches.apply(held, loads);
  loads.compress(VectorOperation::add);
  loads.sadd(-1., 1., imported(forces));
  lines->condense(loads);
  loads.compress(VectorOperation::add);
  return loads;
}



template <int dim>
LA::Vector
MultigridEquilibrium<dim>::solve(const LA::Vector &forces,
                                 const LA::Vector &prescribed,
                                 const LA::Vector &guess)
{
  const Vector b = loads_beside(forces, prescribed);
  check_loads(b.l2_norm());
  Vector x = imported(guess);
  x -= imported(prescribed);
  for (const unsigned int place : lines->owned())
    x.local_element(place) = 0;
  iterate(x, b);

  x.update_ghost_values();
  lines->distribute(x);
  x.zero_out_ghost_values();
  x += imported(prescribed);
  return exported(x);
}



template <int dim>
void
MultigridEquilibrium<dim>::iterate(Vector &x, const Vector &b)
{
  iterations         = 0;
  quality            = {};
  const double scale = b.l2_norm();
  if (scale == 0)
    {
      x = 0;
      return;
    }
  SolverControl control(std::min(parameters.max_iterations, most_iterations),
                        parameters.tolerance * scale);
  try
    {
      SolverCG<Vector>(control).solve(*stiffness, x, b, *multigrid);
    }
  catch (const SolverControl::NoConvergence &)
    {
      // The true residual, below, decides.
    }
  iterations = control.last_step();

  Vector rest(b), correction(b);
  stiffness->vmult(rest, x);
  rest.sadd(-1., 1., b);
  multigrid->vmult(correction, rest);
  quality.residual     = rest.l2_norm() / scale;
  const double largest = x.linfty_norm();
  if (largest > 0)
    quality.uncertainty = correction.linfty_norm() / largest;
  // The iteration's own residual differs a little from the true one.
  if (!(quality.residual <= std::max(failed_above, 2 * parameters.tolerance)))
    {
      std::ostringstream message;
      message << "Conjugate gradients with multigrid left a relative residual "
                 "of "
              << quality.residual << " after " << iterations
              << " iterations. Set Solver/Method = direct, or allow more "
                 "iterations with Solver/Maximum iterations.";
      throw SolverError(message.str());
    }
}



template <int dim>
SolveQuality
MultigridEquilibrium<dim>::quality_of_last() const
{
  return quality;
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
