// SPDX-License-Identifier: LGPL-2.1-or-later
// A law that counts the accepted states: its body deforms as that of Hooke's
// law does, and every point of every cell keeps its count through surgery, on
// refined cells and several processes, and through a checkpoint.

#include <setsudan/simulation/record/checkpoint.h>
#include <setsudan/simulation/record/resumption.h>
#include <setsudan/simulation/state.h>

#include <deal.II/base/mpi.h>

#include <string>

#include "../mechanics/counting_law.h"
#include "../parameters/check.h"
#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

/** How many counts of this process's points differ from the right one. */
template <int dim>
unsigned int
n_wrong(const CutBody<dim> &body, const double count)
{
  unsigned int n = 0, n_cells = 0;
  for (const auto &item : body.model().internal.by_cell())
    {
      ++n_cells;
      for (const double value : item.second)
        n += value != count;
      n += item.second.empty();
    }
  const auto &triangulation = body.model().discretization.triangulation;
  return n + (n_cells != triangulation.n_locally_owned_active_cells());
}


template <int dim>
Scene<dim>
make_scene(const std::vector<SceneEntry> &more)
{
  std::vector<SceneEntry> entries = {
    {"Body", "Elements", dim == 3 ? "2,2,2" : "4,4", ""},
    {"Support", "Fixed faces", "bottom", ""},
    {"Blade", "Edge loads", dim == 3 ? "1:1, 4:2" : "0:1", ""},
    {"Load", "Body force", dim == 3 ? "0.01, 0.02, -0.1" : "0.1, -0.1", ""},
    {"Division", "Solve", "every row anew", ""},
    {"Solver", "Method", "direct", ""},
    {"Cut", "Surfaces", dim == 3 ? "y:1" : "x:2", ""}};
  entries.insert(entries.end(), more.begin(), more.end());
  return Scene<dim>(Parameters("test", entries, Scene<dim>::declare));
}


template <int dim>
void
test(const std::vector<SceneEntry> &more)
{
  const Scene<dim> elastic = make_scene<dim>(more);
  Scene<dim> counting      = make_scene<dim>(more);
  counting.material.set_law(
    0, std::make_shared<CountingLaw>(elastic.material.of_element(0).at_rest));
  CutBody<dim> body(counting, MPI_COMM_WORLD), other(elastic, MPI_COMM_WORLD);
  State<dim> state = rest_state(body), expected = rest_state(other);
  double count       = 0;
  const auto advance = [&](const unsigned int row) {
    state = solve_state(body, body.blade_on_row(row), 1, state.displacement);
    expected =
      solve_state(other, other.blade_on_row(row), 1, expected.displacement);
    body.accept();
    ++count;
    LA::Vector difference = state.displacement;
    difference -= expected.displacement;
    check_below_on_all("  displacement",
                       difference.linfty_norm() /
                         expected.displacement.linfty_norm(),
                       1e-9);
    check_below_on_all(
      "  energy",
      std::abs(state.strain_energy / expected.strain_energy - 1),
      1e-9);
    check_below_on_all("  wrong counts", n_wrong(body, count), 0);
  };
  for (CutBody<dim> *const each : {&body, &other})
    each->begin_cut(each->scene().cut.cuts[0]);
  advance(0);
  state.displacement    = body.split_nodes(state.displacement);
  expected.displacement = other.split_nodes(expected.displacement);
  check_below_on_all(
    "  wrong counts behind the surgery", n_wrong(body, count), 0);
  for (CutBody<dim> *const each : {&body, &other})
    each->release_row(0);
  advance(1);

  Checkpoint checkpoint;
  checkpoint.stage               = Checkpoint::Stage::row;
  checkpoint.event.row           = 1;
  checkpoint.event.strain_energy = state.strain_energy;
  store_state(state, body, checkpoint);
  checkpoint.internal =
    Utilities::MPI::broadcast(MPI_COMM_WORLD, checkpoint.internal);
  checkpoint.displacement =
    Utilities::MPI::broadcast(MPI_COMM_WORLD, checkpoint.displacement);
  checkpoint.load_factor = 1;
  CutBody<dim> resumed(counting, MPI_COMM_WORLD);
  repeat_surgeries(checkpoint, resumed);
  restore_state(checkpoint, resumed);
  check_below_on_all("  wrong counts when resumed", n_wrong(resumed, count), 0);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    say("2D");
    test<2>({});
    say("3D");
    test<3>({});
    say("2D, refined near the cut");
    test<2>({{"Cut", "Refinement near cut", "1", ""}});
    say("2D, linear elements");
    test<2>({{"Body", "Element type", "linear", ""}});
  });
}
