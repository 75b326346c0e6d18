// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/solver/tangent_solver.h>

#include <setsudan/solver/linear/linear_solver.h>

#include <cmath>
#include <limits>

namespace Setsudan
{
using namespace dealii;

SolveQuality
combine(const SolveQuality &a, const SolveQuality &b)
{
  return {std::max(a.residual, b.residual),
          std::max(a.estimated_relative_error, b.estimated_relative_error),
          a.warning.empty() || b.warning.empty() || a.warning == b.warning
            ? (a.warning.empty() ? b.warning : a.warning)
            : a.warning + " " + b.warning,
          std::max(a.force_scale, b.force_scale)};
}



bool
converged(const double residual,
          const double loads,
          const double norm_of_matrix,
          const LA::Vector &x,
          const double accepted)
{
  // Beyond this a solve has failed in any case.
  constexpr double lost_above = 1e-5;
  const double round_off =
    10 * std::numeric_limits<double>::epsilon() * norm_of_matrix * x.l2_norm();
  // Written so that a residual that is not a number fails as well.
  return residual <= accepted * loads ||
         (residual <= round_off && residual <= lost_above * loads);
}



LA::Vector
iterative_refinement(LA::Vector &x,
                     const double wanted,
                     const RefinedSystem &system)
{
  constexpr unsigned int most = 5;
  LA::Vector residual         = system.residual_of(x);
  double norm                 = system.norm(residual);
  bool converges              = true;
  for (unsigned int n = 0; n < most && converges && norm > wanted; ++n)
    {
      LA::Vector better = system.correction(residual);
      better += x;
      const LA::Vector new_residual = system.residual_of(better);
      const double new_norm         = system.norm(new_residual);
      if (!(new_norm < norm))
        break;
      converges = new_norm < norm / 2;
      x         = better;
      residual  = new_residual;
      norm      = new_norm;
    }
  return residual;
}



template <int dim>
double
round_off_of_forces(const Discretization<dim> &discretization,
                    const double norm_of_matrix)
{
  double squares = 0;
  for (const auto &[position, component] : discretization.dof_locations())
    squares += position[component] * position[component];
  squares = Utilities::MPI::sum(squares, discretization.communicator);
  return std::numeric_limits<double>::epsilon() * norm_of_matrix *
         std::sqrt(squares);
}



void
check_loads(const double norm)
{
  if (!std::isfinite(norm))
    throw SolverError(
      "The loads exceed the range of numbers, the sum of their squares is no "
      "number. Choose units of force and length in which they are smaller.");
}



SolveQuality
quality_of(const LA::Vector &x,
           const LA::Vector &correction,
           const double residual,
           const double loads)
{
  const double largest = x.linfty_norm();
  SolveQuality quality;
  quality.residual = loads > 0 ? residual / loads : 0;
  quality.estimated_relative_error =
    largest > 0 ? correction.linfty_norm() / largest : 0;
  return quality;
}



template double
round_off_of_forces(const Discretization<2> &, const double);
template double
round_off_of_forces(const Discretization<3> &, const double);
} // namespace Setsudan
