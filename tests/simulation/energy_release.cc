// SPDX-License-Identifier: LGPL-2.1-or-later
// The energy that a row would release: the difference of the potential energies
// with and without its ties, half the ties' forces times the opening, and a
// square of the load. The areas of rows sum up to that of the cut.

#include <setsudan/simulation/drive.h>
#include <setsudan/solver/assembled_solver.h>

#include <deal.II/base/mpi.h>

#include <cmath>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

/** The work of the row's ties on its opening: the forces on the plus side are
 * what K u leaves over from the loads. */
template <int dim>
double
work_of_ties(CutBody<dim> &body,
             const unsigned int row,
             const State<dim> &tied,
             const LA::Vector &released)
{
  LA::Vector ties = internal_forces(body.model(), tied.displacement);
  ties -= tied.forces;
  double work = 0;
  for (const unsigned int p : body.seam().rows()[row].pairs)
    for (unsigned int c = 0; c < dim; ++c)
      for (const auto index :
           {body.seam().pairs()[p].plus[c], body.seam().pairs()[p].minus[c]})
        if (body.model().discretization.owned.is_element(index))
          work += ties(index) * (released(index) - tied.displacement(index));
  return -Utilities::MPI::sum(work, MPI_COMM_WORLD) / 2;
}


/** A solver that has taken nothing over from other states. */
template <int dim>
AssembledSolver<dim>
anew(const CutBody<dim> &body, const dealii::AffineConstraints<double> &held)
{
  return AssembledSolver<dim>(
    body.model(),
    held,
    body.scene().solver,
    choose_fallback(size_of(body.model().discretization)));
}


template <int dim>
void
test(const std::vector<SceneEntry> &more)
{
  std::vector<SceneEntry> entries = {
    {"Body", "Elements", dim == 3 ? "2,2,2" : "4,4", ""},
    {"Support", "Fixed faces", "bottom", ""},
    {"Blade", "Edge loads", dim == 3 ? "1:1, 4:2" : "0:1", ""},
    {"Load", "Body force", dim == 3 ? "0.01, 0.02, -0.1" : "0.1, -0.1", ""},
    {"Yield", "Criterion", "energy release", ""},
    {"Material", "Toughness", "0.25", ""},
    {"Blade", "Sharpness", "0.2", ""},
    {"Cut", "Surfaces", dim == 3 ? "y:1" : "x:2", ""}};
  entries.insert(entries.end(), more.begin(), more.end());
  const Scene<dim> scene(Parameters("test", entries, Scene<dim>::declare));
  CutBody<dim> body(scene, MPI_COMM_WORLD);
  body.begin_cut(scene.cut.cuts[0]);
  body.split_nodes();
  body.release_row(0);

  const unsigned int row = 1;
  const auto blade       = body.blade_on_row(row);
  const LA::Vector zero  = body.model().discretization.zero_vector();
  const auto without =
    body.constraints(body.seam().released(body.pair_states(), row));
  // Its opening is that of the row before, and none of its own.
  const auto released_under = [&](const BladeLoad<dim> &load) {
    State<dim> released = loaded_state(body, load, 1);
    set_solution(
      body.model(),
      anew(body, without).solve(released.forces, lift_of(body, released), zero),
      released);
    return released;
  };
  const auto energy = [&](const State<dim> &state) {
    return state.internal * state.displacement / 2 -
           state.forces * state.displacement;
  };
  const double area = body.area_of_row(row).area;

  // The blade follows the front, and works on its way.
  State<dim> tied = solve_state(body, blade, 1, zero);
  check_yield(body, row, tied);
  const auto &rows          = body.seam().rows();
  const bool is_last        = row + 1 == rows.size();
  const State<dim> released = released_under(
    is_last ? no_blade(body.model()) : body.blade_on_row(row + 1));
  const double force = body.cut().edge_loads.sum();
  // Layers of elements are of one depth.
  const double work = force * (is_last ? rows[row].depth - rows[row - 1].depth
                                       : rows[row + 1].depth - rows[row].depth);
  // Large numbers, of which few digits remain where rows are fine.
  check_below_on_all("  difference of energies",
                     std::abs((energy(tied) - energy(released) + work) /
                                (tied.stress.reached * area) -
                              1),
                     1e-8);
  check_below_on_all("  required", std::abs(tied.stress.required - 0.2), 1e-12);

  // Without a blade what is set free is the work of the ties.
  const BladeLoad<dim> nothing_there = no_blade(body.model());
  State<dim> without_blade = solve_state(body, nothing_there, 0, zero);
  check_yield(body, row, without_blade);
  check_below_on_all(
    "  work of the ties",
    std::abs(
      work_of_ties(
        body, row, without_blade, released_under(nothing_there).displacement) /
        (without_blade.stress.reached * area) -
      1),
    1e-9);

  // Without an opening and other loads it is proportional to the load, and
  // beyond that to its square.
  const LinearResponse nothing{zero, zero, zero, 0};
  const auto constraints = body.constraints();
  const LinearResponse per_load{
    anew(body, constraints).solve(blade.nodal_forces, zero, zero).displacement,
    blade.nodal_forces,
    zero,
    1};
  SolveQuality quality;
  const auto at =
    scene.criterion->evaluate(body, row, nothing, &per_load, quality);
  const auto beyond = [&](const double factor) {
    return at(factor).reached * area - factor * work;
  };
  check_below_on_all("  square of the load",
                     std::abs(beyond(0.03) / (9 * beyond(0.01)) - 1),
                     1e-11);

  double sum = 0;
  for (unsigned int r = 0; r < body.seam().rows().size(); ++r)
    sum += body.area_of_row(r).area;
  const double whole =
    measure_surface(scene.body, scene.cut.cuts[0].surface.faces).area;
  check_below_on_all("  areas", std::abs(sum / whole - 1), 1e-12);
  // The cut is as wide everywhere, however fine the rows are.
  const auto width = [&](const unsigned int r) {
    return body.area_of_row(r).area / (rows[r + 1].depth - rows[r].depth);
  };
  double uneven = 0;
  for (unsigned int r = 1; r + 1 < rows.size(); ++r)
    uneven = std::max(uneven, std::abs(width(r) / width(0) - 1));
  check_below_on_all("  widths", uneven, 1e-9);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    say("2D");
    test<2>({});
    say("2D, refined near the cut");
    test<2>({{"Cut", "Refinement near cut", "1", ""}});
    say("2D, two levels near the cut");
    test<2>({{"Cut", "Refinement near cut", "2", ""}});
    say("3D");
    test<3>({});
    say("3D, rows of elements");
    test<3>({{"Division", "Release", "element row", ""}});
    say("3D, nearly incompressible");
    test<3>({{"Material", "Poisson's ratio", "0.499", ""}});
  });
}
