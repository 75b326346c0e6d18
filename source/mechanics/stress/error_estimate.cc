// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/mechanics/stress/error_estimate.h>
#include <setsudan/mechanics/stress/stress_evaluator.h>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** stress : strain, with the strain that a linear law gives to it. */
double
energy_density(const Material &material, const SymmetricTensor<2, 3> &stress)
{
  if (const auto *const stiffness = material.law->anisotropic_stiffness())
    return stress * (invert(*stiffness) * stress);
  const auto &[lambda, mu]  = material.at_rest;
  const auto shear          = deviator(stress);
  const double bulk_modulus = lambda + 2 * mu / 3;
  const double mean         = trace(stress) / 3;
  return shear * shear / (2 * mu) + mean * mean / bulk_modulus;
}
} // namespace


template <int dim>
ErrorEstimate
estimate_error(const ElasticModel<dim> &model,
               const RecoveredStress<dim> &recovered,
               const LA::Vector &displacement)
{
  const auto &discretization = model.discretization;
  StressEvaluator<dim> recovery(
    discretization, model.materials, gauss_points(discretization));
  ErrorEstimate estimate;
  estimate.squares.reinit(discretization.triangulation.n_active_cells());
  double of_error = 0, of_state = 0;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const Material &material =
          model.materials.of_element(discretization.element(cell));
        recovery.reinit(cell, displacement);
        const auto smooth = recovered.evaluate(cell, recovery);
        double square     = 0;
        for (unsigned int p = 0; p < recovery.n_points(); ++p)
          {
            const auto stress = recovery.stress(p);
            square +=
              energy_density(material, smooth[p] - stress) * recovery.volume(p);
            of_state += energy_density(material, stress) * recovery.volume(p);
          }
        estimate.squares(cell->active_cell_index()) = square;
        of_error += square;
      }
  of_error = Utilities::MPI::sum(of_error, discretization.communicator);
  of_state = Utilities::MPI::sum(of_state, discretization.communicator);
  estimate.relative_energy = of_state > 0 ? of_error / of_state : 0.;
  return estimate;
}



template ErrorEstimate
estimate_error(const ElasticModel<2> &,
               const RecoveredStress<2> &,
               const LA::Vector &);
template ErrorEstimate
estimate_error(const ElasticModel<3> &,
               const RecoveredStress<3> &,
               const LA::Vector &);
} // namespace Setsudan
