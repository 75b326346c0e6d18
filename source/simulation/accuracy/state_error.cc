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
estimate_error_of_state(const Scene<dim> &scene,
                        const CutBody<dim> &body,
                        const std::optional<unsigned int> &row,
                        const State<dim> &state)
{
  const auto &model = *body.model;
  const LA::Vector displacement =
    model.discretization.with_ghosts(state.displacement);
  const RecoveredStress<dim> recovered(model, displacement);
  StateError error;
  error.energy = estimate_error(model, recovered, displacement);
  if (!row || state.stress.reached == 0)
    return error;
  if (scene.yield.needs_seam())
    error.cutting_stress = error.energy.relative_energy;
  else
    {
      const auto smooth =
        cutting_stress(scene.yield.criterion,
                       front_stresses(model,
                                      body.seam(),
                                      body.seam_cells(),
                                      body.seam().rows()[*row],
                                      scene.yield,
                                      displacement,
                                      &recovered),
                       scene.blade.sharpness,
                       body.communicator);
      error.cutting_stress =
        std::abs(smooth.reached / state.stress.reached - 1);
    }
  return error;
}



template StateError
estimate_error_of_state(const Scene<2> &,
                        const CutBody<2> &,
                        const std::optional<unsigned int> &,
                        const State<2> &);
template StateError
estimate_error_of_state(const Scene<3> &,
                        const CutBody<3> &,
                        const std::optional<unsigned int> &,
                        const State<3> &);
} // namespace Setsudan
