// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/accuracy/state_error.h>

#include <cmath>

namespace Setsudan
{
using namespace dealii;

double
StateError::relative(const AccuracyParameters::Quantity quantity) const
{
  return quantity == AccuracyParameters::Quantity::strain_energy
           ? energy.relative_energy
           : cutting_stress;
}



template <int dim>
StateError
estimate_error_of_state(const CutBody<dim> &body,
                        const std::optional<unsigned int> &row,
                        const State<dim> &state)
{
  const auto &model = body.model();
  const LA::Vector displacement =
    model.discretization.with_ghosts(state.displacement);
  const RecoveredStress<dim> recovered(model, displacement);
  StateError error;
  error.energy = estimate_error(model, recovered, displacement);
  if (!row || state.stress.reached == 0)
    return error;
  const double smooth =
    body.scene().criterion->reached_by(body, *row, displacement, recovered);
  error.cutting_stress = smooth > 0
                           ? std::abs(smooth / state.stress.reached - 1)
                           : error.energy.relative_energy;
  return error;
}



template StateError
estimate_error_of_state(const CutBody<2> &,
                        const std::optional<unsigned int> &,
                        const State<2> &);
template StateError
estimate_error_of_state(const CutBody<3> &,
                        const std::optional<unsigned int> &,
                        const State<3> &);
} // namespace Setsudan
