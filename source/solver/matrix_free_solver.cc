// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/lac/solver_cg.h>

#include <setsudan/solver/linear/linear_solver.h>
#include <setsudan/solver/matrix_free_solver.h>
#include <setsudan/solver/multigrid/p_multigrid.h>
#include <setsudan/solver/solver_choice.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <utility>

namespace Setsudan
{
using namespace dealii;

template <int dim>
MatrixFreeSolver<dim>::MatrixFreeSolver(
  const ElasticModel<dim> &model,
  const AffineConstraints<double> &constraints,
  const SolverParameters &parameters,
  const MatrixFreeSolver<dim> *last)
  : ConstrainedSolver<dim>(model, constraints, parameters)
  , max_iterations(
      std::min(parameters.max_iterations, most_multigrid_iterations))
  , tolerance(parameters.tolerance)
{
  model.batches().add_ghost_indices(constraints.get_local_lines());
  const auto &batches = model.batches();
  local_constraints   = std::make_unique<const LocalConstraints>(
    constraints, *batches.partitioner());
  stiffness = std::make_unique<const ConstrainedStiffness<dim>>(
    model.discretization, batches, *local_constraints);
  if (last != nullptr &&
      last->coarse->is_compatible_with(*local_constraints, batches))
    coarse = last->coarse;
  else
    coarse = std::make_shared<const CoarseCorrection<dim>>(
      model, constraints, *local_constraints);
  multigrid = std::make_unique<const PMultigrid<dim>>(*stiffness, coarse);
}



template <int dim>
MatrixFreeSolver<dim>::~MatrixFreeSolver() = default;


template <int dim>
LA::Vector
MatrixFreeSolver<dim>::solve_condensed(const LA::Vector &loads,
                                       const LA::Vector &guess,
                                       SolveQuality &quality)
{
  const double scale = loads.l2_norm();
  check_loads(scale);
  const auto &batches = stiffness->batches;
  const Vector b      = batches.copy_in(loads);
  Vector x            = batches.copy_in(guess);
  Vector residual(b), correction(b);
  iterations = 0;
  if (scale > 0)
    iterate(x, b, residual);
  else
    x = residual = 0;

  multigrid->vmult(correction, residual);
  const LA::Vector result = batches.copy_out(x);
  quality =
    quality_of(result, batches.copy_out(correction), residual.l2_norm(), scale);
  if (!(quality.residual <= accepted))
    fail(quality.residual);
  return result;
}



template <int dim>
void
MatrixFreeSolver<dim>::iterate(Vector &x, const Vector &b, Vector &residual)
{
  // Where cells are slender, the residual that many iterations carry along
  // is smaller than the true one.
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
      stiffness->vmult(residual, x);
      residual.sadd(-1., 1., b);
      const double last = std::exchange(error, residual.l2_norm());
      goes_on           = iterations < max_iterations && error < last / 2 &&
                error > accepted * scale;
    }
}



template <int dim>
void
MatrixFreeSolver<dim>::fail(const double residual) const
{
  std::ostringstream message;
  message << "Conjugate gradients with multigrid left a relative residual of "
          << residual << " after " << iterations << " iterations.";
  throw SolverError(message.str());
}



template <int dim>
unsigned int
MatrixFreeSolver<dim>::n_iterations() const
{
  return iterations;
}



template class MatrixFreeSolver<2>;
template class MatrixFreeSolver<3>;
} // namespace Setsudan
