#include <deal.II/distributed/grid_refinement.h>

#include <setsudan/cut/near_cut.h>
#include <setsudan/simulation/choose_refinement.h>
#include <setsudan/simulation/state_error.h>

#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The error of the body's first deformation, on a body refined so. */
template <int dim>
class Trial
{
public:
  Trial(const Scene<dim> &scene,
        const Refinement &refinement,
        const MPI_Comm communicator)
    : scene(scene)
    , body(scene, refinement, communicator)
  {
    const bool has_cut =
      !scene.cut.cuts.empty() && body.approach(scene.cut.cuts.front());
    const LA::Vector zero = body.model->discretization.zero_vector();
    State<dim> state      = solve_state(
      scene, body, has_cut ? blade_on_row(body, 0) : no_blade(body), 1, zero);
    if (has_cut && !scene.yield.needs_seam())
      judge(scene, body, 0, state);
    error = estimate_error_of_state(scene,
                                    body,
                                    has_cut ? std::optional<unsigned int>(0)
                                            : std::nullopt,
                                    state);
  }

  double
  relative_error() const
  {
    return error.relative(scene.accuracy.quantity);
  }

  unsigned int
  n_cells() const
  {
    return body.model->discretization.triangulation.n_global_active_cells();
  }

  /** The cells that hold half of the error, as far as the scene lets them be
   * refined; the same on all processes. */
  std::vector<CellPath>
  mark()
  {
    auto &triangulation = body.model->discretization.triangulation;
    parallel::distributed::GridRefinement::refine_and_coarsen_fixed_fraction(
      triangulation, error.energy.squares, 0.5, 0.);
    const NearCut<dim> near_cut(scene.body, scene.cut, scene.accuracy.width);
    std::vector<CellPath> own;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && cell->refine_flag_set() &&
          (scene.accuracy.width == 0 || near_cut.is_near(cell)))
        own.push_back(path_of_cell<dim>(cell));
    return gather_cells(own, body.communicator);
  }

private:
  const Scene<dim> &scene;
  CutBody<dim> body;
  StateError error;
};



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
    scene.body, scene.cut, scene.shape.refinement, communicator);
  if (accuracy.target == 0)
    return refinement;

  for (unsigned int n_trials = 1;; ++n_trials)
    {
      Trial<dim> trial(scene, refinement, communicator);
      const std::string choice = describe_choice(
        accuracy, trial.relative_error(), trial.n_cells(), n_trials);
      if (trial.relative_error() <= accuracy.target)
        {
          progress.say(choice);
          return refinement;
        }
      const auto marked = trial.mark();
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
