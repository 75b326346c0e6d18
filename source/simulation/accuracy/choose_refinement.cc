// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/surface/near_cut.h>
#include <setsudan/simulation/accuracy/choose_refinement.h>
#include <setsudan/simulation/accuracy/refinement_trial.h>

#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
std::string
describe_choice(const AccuracyParameters &accuracy,
                const double error,
                const unsigned int n_cells,
                const unsigned int n_trials)
{
  std::ostringstream line;
  line.precision(2);
  line << "Accuracy: an estimated error of " << 100 * error << " % of the "
       << accuracy.quantity_name() << " with " << n_cells
       << " cells, chosen in " << n_trials
       << (n_trials == 1 ? " trial" : " trials")
       << " for Accuracy/Target = " << 100 * accuracy.target << " %.";
  return line.str();
}
} // namespace


template <int dim>
Refinement
choose_refinement(const Scene<dim> &scene,
                  Progress &progress,
                  const MPI_Comm communicator)
{
  const auto &accuracy  = scene.accuracy;
  Refinement refinement = refine_near_cuts(
    scene.body, scene.cut, scene.body_parameters.refinement, communicator);
  if (accuracy.target == 0)
    return refinement;

  std::vector<TrialRecord> records;
  for (unsigned int n_trials = 1;; ++n_trials)
    {
      const RefinementTrial<dim> trial(
        scene, refinement, records, communicator);
      records.push_back(trial.record());
      const std::string choice = describe_choice(
        accuracy, trial.relative_error(), trial.n_cells(), n_trials);
      if (trial.relative_error() <= accuracy.target)
        {
          progress.info(choice);
          return refinement;
        }
      const auto &marked = trial.marked();
      const Refinement finer =
        refine_further(scene.body, scene.cut, refinement, marked, communicator);
      const auto n_finer = count_cells<dim>(scene.body.mesh, finer);
      if (marked.empty() || n_finer > accuracy.max_cells)
        {
          progress.warn(
            "Accuracy/Target is not reached: " +
            (marked.empty()
               ? std::string(
                   "the error lies beyond Accuracy/Width from the cuts")
               : std::to_string(n_finer) +
                   " cells would be next, more than Accuracy/Maximum cells") +
            ". " + choice);
          return refinement;
        }
      refinement = finer;
    }
}



template Refinement
choose_refinement(const Scene<2> &, Progress &, const MPI_Comm);
template Refinement
choose_refinement(const Scene<3> &, Progress &, const MPI_Comm);
} // namespace Setsudan
