// SPDX-License-Identifier: LGPL-2.1-or-later
// A force that is spread evenly over the front: its nodes take what the shape
// functions along the front's lines give them.

#include <setsudan/simulation/cut_body.h>

#include <cmath>

#include "../parameters/check.h"
#include "../test_setup.h"
#include "block_file.h"

using namespace Setsudan;
using namespace dealii;

using Entries = std::vector<SceneEntry>;

/** Where the layers of nodes across the edge are. */
constexpr std::array<double, 4> layers = {{0, 1, 4, 10}};

/** What a force of 10 along 10 gives the nodes of lines of 1, 3 and 6. */
void
test_graded(const std::string &type,
            const std::string &release,
            const unsigned int row,
            const std::vector<double> &expected)
{
  write_block("graded.msh", {{3, 2, 2}}, [](const auto &at) {
    return Point<3>(layers[at[0]], 5. * at[1], 5. * at[2]);
  });
  const Scene<3> scene(
    Parameters("test",
               {{"Body", "Shape", "file", ""},
                {"Body", "File", "graded.msh", ""},
                {"Body", "Element type", type, ""},
                {"Support", "Fixed boxes", "0,0,0,10,10,0 : xyz", ""},
                {"Blade", "Edge loads", "uniform : 10", ""},
                {"Cut", "Surfaces", "where : y - 5", ""},
                {"Division", "Release", release, ""}},
               Scene<3>::declare));
  CutBody<3> body(scene, MPI_COMM_WORLD);
  body.begin_cut(scene.cut.cuts[0]);
  body.split_nodes();
  const auto load   = body.blade_on_row(row);
  const auto &front = body.seam().rows()[row].front;
  const auto &pairs = body.seam().pairs();
  double error = 0, force = 0, moment = 0;
  for (unsigned int i = 0; i < front.size(); ++i)
    {
      const auto &pair = pairs[front[i]];
      const double here =
        -load.nodal_forces(pair.minus[2]) - load.nodal_forces(pair.plus[2]);
      error = std::max(error, std::abs(here - expected.at(i)));
      force += here;
      moment += here * (pair.position[0] - 5);
    }
  std::cout << type << ", row " << row << " of " << release << ":" << std::endl;
  check("  all nodes of the front", front.size() == expected.size());
  check_below("  weights", error, 1e-12);
  check_below("  force", std::abs(force - 10), 1e-12);
  check_below("  moment about the middle", std::abs(moment), 1e-12);
}

/** A point takes it all, and each cut has its own loads. */
void
test_cuts()
{
  const Scene<2> scene(
    Parameters("test",
               {{"Body", "Elements", "4,4", ""},
                {"Support", "Fixed faces", "bottom", ""},
                {"Blade", "Edge loads", "uniform : 3; 0:1, uniform : 4", ""},
                {"Cut", "Surfaces", "x:1; x:3", ""}},
               Scene<2>::declare));
  CutBody<2> body(scene, MPI_COMM_WORLD);
  for (const auto &cut : scene.cut.cuts)
    {
      body.begin_cut(cut);
      body.split_nodes();
      const auto &row = body.seam().rows()[1];
      const auto &at  = body.seam().pairs()[row.front[0]];
      std::cout << "in the plane: whole force " << cut.edge_loads.sum()
                << ", on the front's " << row.front.size() << " node "
                << -2 * body.blade_on_row(1).nodal_forces(at.minus[1])
                << std::endl;
      for (unsigned int r = 0; r < body.seam().rows().size(); ++r)
        body.release_row(r);
      body.finish_cut();
    }
}

int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    const std::vector<double> quadratic = {
      1. / 6, 4. / 6, 1. / 6 + 3. / 6, 12. / 6, 3. / 6 + 1, 4, 1};
    const std::vector<double> linear = {0.5, 2, 4.5, 3};
    test_graded("serendipity", "element row", 0, quadratic);
    test_graded("serendipity", "face band", 1, quadratic);
    test_graded("quadratic", "element row", 1, quadratic);
    test_graded("linear", "element row", 0, linear);
    // A layer in the middle of lines: straight from node to node.
    test_graded("serendipity", "node row", 1, linear);
    test_cuts();
    for (const std::string loads : {"uniform", "uniform :", "even : 3"})
      print_refusal([&] {
        Scene<2>(Parameters(
          "test", {{"Blade", "Edge loads", loads, ""}}, Scene<2>::declare));
      });
  });
}
