// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/distributed/grid_refinement.h>

#include <setsudan/cut/surface/near_cut.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/simulation/accuracy/refinement_trial.h>
#include <setsudan/simulation/drive.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Setsudan
{
using namespace dealii;

namespace
{
// Changes from trial to trial that fall by less are no convergence yet.
constexpr double slowest_convergence = 0.7;
} // namespace


template <int dim>
RefinementTrial<dim>::RefinementTrial(const Scene<dim> &scene,
                                      const Refinement &refinement,
                                      const std::vector<TrialRecord> &earlier,
                                      const MPI_Comm communicator)
  : scene(scene)
  , earlier(earlier)
  , body(scene, refinement, communicator)
{
  body.expect_single_states();
  if (scene.cut.cuts.empty() || !body.begin_cut(scene.cut.cuts.front()))
    {
      add_state({});
      return;
    }
  using States              = AccuracyParameters::States;
  const unsigned int middle = middle_row();
  of_this.middle            = body.seam().rows()[middle].depth;
  if (scene.accuracy.states != States::middle_row || middle == 0)
    add_state(0);
  if (scene.accuracy.states != States::first_row && middle > 0)
    {
      if (open_up_to(middle))
        add_state(middle);
      else if (of_this.values.empty())
        throw FloatingPieceError(
          "Accuracy/States = middle row: on the way to that row the cut severs "
          "a piece that nothing holds. Take the first row.");
    }
}



template <int dim>
unsigned int
RefinementTrial<dim>::middle_row() const
{
  const auto &rows = body.seam().rows();
  if (earlier.empty())
    return rows.size() / 2;
  // Nodes stay where they are when cells are refined.
  const double depth = earlier.front().middle;
  return std::min_element(rows.begin(),
                          rows.end(),
                          [&](const Row &a, const Row &b) {
                            return std::abs(a.depth - depth) <
                                   std::abs(b.depth - depth);
                          }) -
         rows.begin();
}



template <int dim>
bool
RefinementTrial<dim>::open_up_to(const unsigned int row)
{
  body.split_nodes();
  try
    {
      for (unsigned int before = 0; before < row; ++before)
        if (!body.is_left_out(before))
          body.release_row(before);
    }
  catch (const FloatingPieceError &)
    {
      // A piece comes off that nothing holds: the run says so if it gets there.
      return false;
    }
  return !body.is_left_out(row);
}



template <int dim>
void
RefinementTrial<dim>::add_state(const std::optional<unsigned int> &row)
{
  State<dim> state =
    solve_state(body,
                row ? body.blade_on_row(*row) : no_blade(body.model()),
                1,
                body.model().discretization.zero_vector());
  if (row && !scene.needs_seam())
    check_yield(body, *row, state);
  const StateError error = estimate_error_of_state(body, row, state);
  of_this.values.push_back(scene.accuracy.quantity ==
                                 AccuracyParameters::Quantity::cutting_stress &&
                               state.stress.reached > 0
                             ? state.stress.reached
                             : state.strain_energy);
  const double relative =
    error_of_last(error.relative(scene.accuracy.quantity));
  worst_error = std::max(worst_error, relative);
  if (relative > scene.accuracy.target)
    mark(error, row);
}



template <int dim>
double
RefinementTrial<dim>::error_of_last(const double estimate) const
{
  const unsigned int n = earlier.size();
  const unsigned int s = of_this.values.size() - 1;
  if (n < 2 || earlier[n - 2].values.size() <= s ||
      earlier[n - 1].values.size() <= s)
    return estimate;
  const double value  = of_this.values[s];
  const double before = earlier[n - 1].values[s] - earlier[n - 2].values[s];
  const double now    = value - earlier[n - 1].values[s];
  const double ratio  = now / before;
  if (!(ratio > 0 && ratio < slowest_convergence))
    return estimate;
  return std::min(estimate, std::abs(now / value) * ratio / (1 - ratio));
}



template <int dim>
void
RefinementTrial<dim>::mark(const StateError &error,
                           const std::optional<unsigned int> &row)
{
  auto &triangulation             = body.triangulation();
  dealii::Vector<double> of_cells = error.energy.squares;
  of_cells.scale(weights(row));
  parallel::distributed::GridRefinement::refine_and_coarsen_fixed_fraction(
    triangulation, of_cells, 0.5, 0.);
  const double width = scene.accuracy.width;
  const NearCut<dim> near_cut(scene.body, scene.cut, width);
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned() && cell->refine_flag_set() &&
        (width == 0 || near_cut.is_near(cell)))
      cells.push_back(path_of_cell<dim>(cell));
  cells = gather_cells(cells, body.communicator());
}



template <int dim>
dealii::Vector<double>
RefinementTrial<dim>::weights(const std::optional<unsigned int> &row) const
{
  const auto &triangulation = body.model().discretization.triangulation;
  dealii::Vector<double> result(triangulation.n_active_cells());
  result = 1;
  if (!row ||
      scene.accuracy.quantity == AccuracyParameters::Quantity::strain_energy)
    return result;
  std::vector<Point<dim>> front;
  for (const unsigned int pair : body.seam().rows()[*row].front)
    front.push_back(body.seam().pairs()[pair].position);
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const double reach =
          std::max(scene.yield.process_zone, cell->diameter());
        double distance = std::numeric_limits<double>::max();
        for (const auto &point : front)
          distance = std::min(distance, cell->center().distance(point));
        result(cell->active_cell_index()) =
          std::pow(reach / std::max(reach, distance), dim);
      }
  return result;
}



template <int dim>
double
RefinementTrial<dim>::relative_error() const
{
  return worst_error;
}



template <int dim>
unsigned int
RefinementTrial<dim>::n_cells() const
{
  return body.model().discretization.triangulation.n_global_active_cells();
}



template <int dim>
const TrialRecord &
RefinementTrial<dim>::record() const
{
  return of_this;
}



template <int dim>
const std::vector<CellPath> &
RefinementTrial<dim>::marked() const
{
  return cells;
}



template class RefinementTrial<2>;
template class RefinementTrial<3>;
} // namespace Setsudan
