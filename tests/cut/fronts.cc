// SPDX-License-Identifier: LGPL-2.1-or-later
// Fronts that no axis follows, because they are closed or run back: positions
// are lengths along them, and a place keeps its position in all rows, so that
// the blade's loads stay where they are while it goes on.

#include <setsudan/simulation/cut_body.h>

#include <cmath>
#include <map>

#include "../parameters/check.h"
#include "../test_setup.h"

using namespace Setsudan;

/** The blade goes straight down through a body of 4 x 4 x 2 elements. */
void
test(const std::string &name, const std::string &surface)
{
  const Parameters parameters("test",
                              {{"Body", "Elements", "4,4,2", ""},
                               {"Support", "Fixed faces", "bottom", ""},
                               {"Cut", "Surfaces", surface, ""}},
                              Scene<3>::declare);
  const Scene<3> scene(parameters);
  CutBody<3> body(scene, MPI_COMM_WORLD);
  body.begin_cut(scene.cut.cuts[0]);
  const auto &pairs = body.seam().pairs();
  std::cout << name << std::endl;
  double error = 0, moved = 0;
  std::map<std::pair<double, double>, double> position_of_place;
  for (const auto &row : body.seam().rows())
    {
      const auto &front = row.front;
      std::cout << "  depth " << row.depth << ": " << row.pairs.size()
                << " nodes, " << front.size() << " in the front, length "
                << row.positions.back()
                << (front.front() == front.back() ? ", closed" : "")
                << std::endl;
      error = std::max(error, std::abs(row.positions.front()));
      for (unsigned int i = 0; i < front.size(); ++i)
        {
          const auto &p = pairs[front[i]].position;
          if (i > 0)
            error =
              std::max(error,
                       std::abs(row.positions[i] - row.positions[i - 1] -
                                p.distance(pairs[front[i - 1]].position)));
          // The end of a closed front is its beginning.
          if (i > 0 && front[i] == front[0])
            continue;
          const auto inserted = position_of_place.emplace(
            std::make_pair(p[0], p[1]), row.positions[i]);
          moved = std::max(moved,
                           std::abs(inserted.first->second - row.positions[i]));
        }
    }
  check_below("  positions are lengths", error, 1e-13);
  check_below("  places keep their positions", moved, 1e-13);
}

int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    // Around four elements, and around two of them.
    test("closed", "where : max(abs(x - 5), abs(y - 5)) - 2.5");
    test("closed, smaller", "where : max(abs(x - 5), abs(2*y - 7.5)) - 2.5");
    // Along the edges of elements like an S: twice to the right, once back.
    test("running back",
         "where : min(y - 2.5, max(y - 7.5, min(5 - x, max(2.5 - x, 5 - y))))");
  });
}
