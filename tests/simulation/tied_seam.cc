// SPDX-License-Identifier: LGPL-2.1-or-later
// A seam whose pairs are all tied is the uncut body: for surfaces of all kinds,
// next to elements that are refined and that are not, under supports and clamps
// that the cut goes through, and across the cuts before it.

#include <setsudan/simulation/state.h>

#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

#include "../parameters/check.h"
#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

template <int dim>
LA::Vector
solve(CutBody<dim> &body)
{
  return solve_state(body,
                     body.blade_on_row(0),
                     1,
                     body.model().discretization.zero_vector())
    .displacement;
}

/** Make all cuts, each after its seam was compared while it was tied. */
template <int dim>
void
test(const std::string &surfaces, const std::vector<SceneEntry> &more = {})
{
  std::vector<SceneEntry> entries = {
    {"Body", "Elements", dim == 3 ? "4,4,2" : "4,4", ""},
    {"Material", "Poisson's ratio", "0.3", ""},
    {"Support", "Fixed faces", "bottom", ""},
    {"Blade", "Edge loads", dim == 3 ? "1:1, 4:2" : "0:1", ""},
    {"Load", "Body force", dim == 3 ? "0.1, 0, -0.1" : "0.1, -0.1", ""},
    {"Cut", "Surfaces", surfaces, ""}};
  entries.insert(entries.end(), more.begin(), more.end());
  const Parameters parameters("test", entries, Scene<dim>::declare);
  const Scene<dim> scene(parameters);
  CutBody<dim> body(scene, MPI_COMM_WORLD);
  std::string name = std::to_string(dim) + "D, " + surfaces;
  for (const auto &entry : more)
    name += ", " + entry.name + " = " + entry.value;
  if (is_first_process())
    std::cout << name << std::endl;
  for (const auto &cut : scene.cut.cuts)
    {
      body.begin_cut(cut);
      const LA::Vector carried = body.split_nodes(solve(body));
      LA::Vector difference    = solve(body);
      difference -= carried;
      const double error = difference.linfty_norm() / carried.linfty_norm();
      if (is_first_process())
        {
          check("  two sides", body.seam().n_double_pairs() > 0);
          check_below("  tied", error, 1e-10);
        }
      body.finish_cut();
    }
}

int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    const SceneEntry near_cut{"Cut", "Refinement near cut", "1", ""};
    const SceneEntry slit{"Cut", "Extent", "depth : 5", ""};
    test<2>("x:2", {near_cut, slit});
    test<2>("where : max(x, 5 - y) - 5", {near_cut});
    test<3>("y:2");
    test<3>("y:2", {{"Cut", "Refinement near cut", "2", ""}});
    test<3>("y:2", {near_cut, slit});
    test<3>("y:2; x:2", {near_cut});
    // The cut goes through what is held, and through what is moved.
    test<3>(
      "y:2",
      {near_cut, {"Support", "Displacements", "top : 0.1, free, -0.2", ""}});
    test<3>("y:2",
            {near_cut, {"Support", "Fixed components", "left : yz", ""}});
    // Where a surface turns, an element may touch it in a line only.
    test<3>("where : max(x, y) - 5");
    test<3>("where : max(x, y) - 5", {near_cut});
    test<3>("where : max(x, y) - 5",
            {{"Cut", "Refinement near cut", "1, 0.1", ""}});
    test<3>("plane : 5, 5, 5 ; 1, 1, 0", {near_cut});
    test<3>("where : max(abs(x - 5), abs(y - 5)) - 2.5; x:2", {near_cut});
  });
}
