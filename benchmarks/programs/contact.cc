// SPDX-License-Identifier: LGPL-2.1-or-later
// The contact of a wedge with the walls of a cube of N^3 elements that is cut
// half through, once its cut is prepared: contact N. The wedge travels from the
// entry to the front, again and again, and each change of its contacts is
// followed. Prints names and values in a line: the changes of one way, and the
// milliseconds of each in the mean, which are at least one solve of the active
// set method.

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <setsudan/kernel/blas.h>
#include <setsudan/simulation/cut_contact.h>

#include <iostream>
#include <string>

using namespace Setsudan;
using namespace dealii;

namespace
{
constexpr int dim = 3;

Parameters
parameters(const unsigned int n)
{
  const std::string elements = std::to_string(n);
  return Parameters(
    "benchmark",
    {{"Body", "Size", "1, 1, 1", ""},
     {"Body", "Elements", elements + ", " + elements + ", " + elements, ""},
     {"Support", "Fixed faces", "bottom", ""},
     {"Blade", "Drive", "travel", ""},
     {"Blade", "Direction", "0, 0, -1", ""},
     {"Blade", "Shape", "wedge", ""},
     {"Blade", "Wedge angle", "20", ""},
     {"Blade", "Thickness", "0.1", ""},
     {"Blade", "Shoulder radius", "0.05", ""},
     {"Cut", "Surfaces", "y:" + std::to_string(n / 2), ""},
     {"Division", "Release", "element row", ""},
     {"Yield", "Criterion", "energy release", ""}},
    Scene<dim>::declare);
}
} // namespace


int
main(int argc, char **argv)
{
  start_with_fitting_blas(argv);
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (argc != 2)
    {
      std::cerr << "usage: contact N\n";
      return 1;
    }
  const unsigned int n = std::stoi(argv[1]), n_split = n / 2;
  const Scene<dim> scene(parameters(n));
  CutBody<dim> body(scene, MPI_COMM_WORLD);
  body.begin_cut(scene.cut.cuts[0]);
  body.split_nodes();
  for (unsigned int row = 0; row < n_split; ++row)
    body.release_row(row);
  CutContact<dim> contact(
    body, scene.blade.profile, body.model().discretization.zero_vector());
  const double front     = body.seam().rows()[n_split].depth;
  constexpr double least = 1;
  double seconds         = 0;
  unsigned int n_changes = 0, n_ways = 0;
  for (; seconds < least; ++n_ways)
    {
      const auto path = contact.path(n_split, 0, BladeMotion(), nullptr);
      const Timer timer;
      for (; path->end() < front; ++n_changes)
        path->cross_end();
      seconds += timer.wall_time();
    }
  std::cout << "changes " << n_changes / n_ways << " milliseconds "
            << 1e3 * seconds / n_changes << std::endl;
}
