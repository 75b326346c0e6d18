// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/mechanics/stiffness.h>
#include <setsudan/solver/assembled_solver.h>
#include <setsudan/space/near_null_space.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace Setsudan
{
using namespace dealii;

template <int dim>
AssembledSolver<dim>::AssembledSolver(
  const ElasticModel<dim> &model,
  const AffineConstraints<double> &constraints,
  const SolverParameters &parameters,
  const SolverKind kind,
  std::vector<UnknownForces> all_springs)
  : ConstrainedSolver<dim>(model, constraints, parameters)
  , kind(kind)
  , springs(std::move(all_springs))
  , solver(make_linear_solver(kind, parameters))
{
  if (!springs.empty())
    share_out_springs();
  if (model.is_linear())
    linearize({});
}



template <int dim>
void
AssembledSolver<dim>::share_out_springs()
{
  const MPI_Comm communicator = model.discretization.communicator;
  const unsigned int n_processes =
    Utilities::MPI::n_mpi_processes(communicator);
  const unsigned int present = Utilities::MPI::this_mpi_process(communicator);
  const IndexSet &known      = constraints.get_local_lines();
  std::vector<unsigned int> first;
  for (const auto &spring : springs)
    first.push_back(std::all_of(spring.begin(),
                                spring.end(),
                                [&](const auto &force) {
                                  return known.is_element(force.first);
                                })
                      ? present
                      : n_processes);
  Utilities::MPI::min(first, communicator, first);
  std::vector<UnknownForces> own;
  std::vector<std::vector<types::global_dof_index>> coupled;
  for (unsigned int i = 0; i < springs.size(); ++i)
    {
      AssertThrow(first[i] < n_processes, ExcInternalError());
      if (first[i] != present)
        continue;
      own.push_back(std::move(springs[i]));
      coupled.emplace_back();
      for (const auto &force : own.back())
        coupled.back().push_back(force.first);
    }
  springs = std::move(own);
  reinit_matrix(model.discretization, constraints, coupled, matrix);
}



template <int dim>
void
AssembledSolver<dim>::add_springs()
{
  for (const auto &spring : springs)
    {
      const unsigned int n = spring.size();
      FullMatrix<double> stiffness(n, n);
      std::vector<types::global_dof_index> unknowns;
      for (unsigned int i = 0; i < n; ++i)
        {
          unknowns.push_back(spring[i].first);
          for (unsigned int j = 0; j < n; ++j)
            stiffness(i, j) = spring[i].second * spring[j].second;
        }
      constraints.distribute_local_to_global(stiffness, unknowns, matrix);
    }
  matrix.compress(VectorOperation::add);
}



template <int dim>
void
AssembledSolver<dim>::linearize(const Linearization &linearization,
                                const double shift)
{
  assemble_tangent(model, linearization, constraints, matrix);
  add_springs();
  if (shift > 0)
    {
      double sum = 0;
      for (const auto i : matrix.locally_owned_range_indices())
        sum += std::abs(matrix.diag_element(i));
      sum = Utilities::MPI::sum(sum, model.discretization.communicator);
      for (const auto i : matrix.locally_owned_range_indices())
        matrix.add(i, i, shift * sum / matrix.m());
      matrix.compress(VectorOperation::add);
    }
  solver->initialize(
    matrix,
    solver->is_iterative()
      ? rigid_modes_at<dim>(model.discretization.dof_locations())
      : std::vector<std::vector<double>>());
}



template <int dim>
double
AssembledSolver<dim>::round_off() const
{
  double squares = 0;
  for (const auto &[position, component] : model.discretization.dof_locations())
    squares += position[component] * position[component];
  squares = Utilities::MPI::sum(squares, model.discretization.communicator);
  return std::numeric_limits<double>::epsilon() * matrix.linfty_norm() *
         std::sqrt(squares);
}



template <int dim>
LA::Vector
AssembledSolver<dim>::solve_condensed(const LA::Vector &b,
                                      const LA::Vector &guess,
                                      SolveQuality &quality)
{
  const double scale = b.l2_norm();
  check_loads(scale);
  LA::Vector x = guess;
  solver->solve(x, b);

  RefinedSystem system;
  system.residual_of = [&](const LA::Vector &solution) {
    LA::Vector residual = b;
    matrix.residual(residual, solution, b);
    return residual;
  };
  system.norm = [](const LA::Vector &residual) { return residual.l2_norm(); };
  system.correction = [&](const LA::Vector &residual) {
    LA::Vector correction = b;
    correction            = 0;
    solver->solve(correction, residual);
    return correction;
  };
  // After many iterations the residual that conjugate gradients carry along is
  // smaller than the true one.
  const LA::Vector residual = iterative_refinement(
    x,
    scale * (solver->is_iterative() ? accepted : refinement_threshold),
    system);

  LA::Vector correction = x;
  solver->approximate(correction, residual);
  const double norm = residual.l2_norm();
  quality           = quality_of(x, correction, norm, scale);
  if (!converged(norm, scale, matrix.linfty_norm(), x, accepted))
    fail(quality.residual);
  return x;
}



template <int dim>
void
AssembledSolver<dim>::fail(const double residual) const
{
  std::ostringstream message;
  message << "The " << description(kind)
          << " solver left a relative residual of " << residual
          << ", which must not exceed " << accepted
          << ": the system is singular or nearly so. Check that supports hold "
             "the body, and that stiffnesses do not differ beyond measure.";
  throw SolverError(message.str());
}



template class AssembledSolver<2>;
template class AssembledSolver<3>;
} // namespace Setsudan
