// SPDX-License-Identifier: LGPL-2.1-or-later
// Hats on the top of a block of elements of side 2 x 1 x 1 that a wedge of
// thickness 3 enters: those of two lines of corners on either side, of areas
// 1/2 and 1 and mean distances 1/3 and 1 for each length of the block; the
// third line, the block's rim, is 5/3 away. A wedge of thickness 0.6 is between
// the first ones, and neither a wire nor a blade without a body has any.

#include <setsudan/contact/entry_hats.h>
#include <setsudan/simulation/cut_body.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

void
test(const std::string &shape, const std::string &thickness)
{
  std::vector<SceneEntry> settings = {
    {"Body", "Size", "6, 4, 4", ""},
    {"Body", "Elements", "3, 4, 4", ""},
    {"Support", "Fixed faces", "bottom", ""},
    {"Blade", "Drive", "travel", ""},
    {"Blade", "Shape", shape, ""},
    {"Cut", "Surfaces", "y:2", ""},
    {"Yield", "Criterion", "energy release", ""}};
  if (shape != "line")
    settings.push_back({"Blade", "Thickness", thickness, ""});
  if (shape == "wedge")
    settings.push_back({"Blade", "Wedge angle", "90", ""});
  const Scene<3> scene(Parameters("test", settings, Scene<3>::declare));
  CutBody<3> body(scene, MPI_COMM_WORLD);
  body.begin_cut(scene.cut.cuts[0]);
  body.split_nodes();
  double area = 0, moment = 0, aside = 0, depth = 0;
  for (const auto &entry : body.entry_hats())
    {
      area += entry.hat.area;
      moment += entry.hat.area * entry.offset;
      aside += entry.hat.area * (entry.is_plus ? 1 : -1);
      depth          = std::max(depth, std::abs(entry.depth));
      double weights = 0;
      for (const auto &[node, weight] : entry.hat.nodes)
        weights += weight;
      AssertThrow(std::abs(weights - entry.hat.area) < 1e-12,
                  ExcInternalError());
      const double y = entry.hat.center[1] - 2;
      AssertThrow((y > 0) == entry.is_plus, ExcInternalError());
      AssertThrow(std::abs(std::abs(y) - entry.offset) < 1e-12,
                  ExcInternalError());
    }
  std::cout << shape << ' ' << thickness << ": " << body.entry_hats().size()
            << " hats, area " << area << ", moment " << moment
            << ", sides alike " << (std::abs(aside) < 1e-12)
            << ", at the entry " << (depth < 1e-12) << std::endl;
}



int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test("wedge", "3");
    test("wedge", "0.6");
    test("wire", "3");
    test("line", "0");
  });
}
