#include <setsudan/solver/assembled_solver.h>
#include <setsudan/space/near_null_space.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

template <int dim>
AssembledSolver<dim>::AssembledSolver(
  ElasticModel<dim> &model,
  const AffineConstraints<double> &constraints,
  const SolverParameters &parameters)
  : ConstrainedSolver<dim>(model, constraints, parameters)
  , solver(make_linear_solver(parameters,
                              model.discretization.dof_handler.n_dofs(),
                              model.discretization.communicator))
{
  assemble_stiffness(
    model.discretization, model.stiffness, constraints, matrix);
  solver->initialize(
    matrix,
    solver->is_iterative()
      ? rigid_modes_at<dim>(model.discretization.dof_locations())
      : std::vector<std::vector<double>>());
}



template <int dim>
LA::Vector
AssembledSolver<dim>::solve_condensed(const LA::Vector &b,
                                      const LA::Vector &guess)
{
  const double scale = b.l2_norm();
  check_loads(scale);
  LA::Vector x = guess;
  solver->solve(x, b);

  Refined mending;
  mending.residual_of = [&](const LA::Vector &solution) {
    LA::Vector rest = b;
    matrix.residual(rest, solution, b);
    return rest;
  };
  mending.norm       = [](const LA::Vector &rest) { return rest.l2_norm(); };
  mending.correction = [&](const LA::Vector &rest) {
    LA::Vector correction = b;
    correction            = 0;
    solver->solve(correction, rest);
    return correction;
  };
  // Conjugate gradients that went on for long take for solved what is not.
  const LA::Vector rest = iterative_refinement(
    x,
    scale * (solver->is_iterative() ? accepted : refinement_threshold),
    mending);

  LA::Vector correction = x;
  solver->approximate(correction, rest);
  const double error = rest.l2_norm();
  quality            = quality_of(x, correction, error, scale);
  if (!converged(error, scale, matrix.linfty_norm(), x, accepted))
    fail();
  return x;
}



template <int dim>
std::string
AssembledSolver<dim>::description() const
{
  return solver->description();
}



template <int dim>
void
AssembledSolver<dim>::fail() const
{
  std::ostringstream message;
  message << "The " << solver->description()
          << " solver left a relative residual of " << quality.residual
          << ", which must not exceed " << accepted
          << ": the system is singular or nearly so. Check that supports hold "
             "the body, and that stiffnesses do not differ beyond measure.";
  throw SolverError(message.str());
}



template class AssembledSolver<2>;
template class AssembledSolver<3>;
} // namespace Setsudan
