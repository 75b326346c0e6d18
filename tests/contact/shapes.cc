// SPDX-License-Identifier: LGPL-2.1-or-later
// Blades in the upper half of a block that is cut to there. A wedge that is
// free to shift stays in the middle of a block whose halves are alike, and
// needs the same force as one that is guided; between halves of different
// stiffness it yields to the stiffer one and needs less, as an independent
// program has it. Behind a wire the walls close again.

#include <setsudan/simulation/cut_contact.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

constexpr unsigned int n_rows = 32, n_split = 16;

/** The columns of one half of the block, from the cut: ever wider by a fifth,
 * up to an eighth of the block. */
std::vector<double>
columns()
{
  std::vector<double> ends = {0.};
  double width             = 1. / n_rows;
  while (ends.back() < 0.5 - 1e-12)
    {
      ends.push_back(ends.back() + width);
      width = std::min(1.2 * width, 1. / 8);
    }
  for (auto &end : ends)
    end *= 0.5 / ends.back();
  return ends;
}



/** The unit square, from x = -1/2 and y = 0, its left and its right half being
 * groups. */
void
write_block()
{
  const auto half = columns();
  std::vector<double> xs;
  for (auto x = half.rbegin(); x != half.rend(); ++x)
    xs.push_back(-*x);
  xs.insert(xs.end(), half.begin() + 1, half.end());
  const unsigned int n = xs.size();
  std::ofstream out("block.msh");
  out.precision(17);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
      << "$PhysicalNames\n3\n1 1 \"foot\"\n2 2 \"left\"\n2 3 \"right\"\n"
      << "$EndPhysicalNames\n$Nodes\n"
      << n * (n_rows + 1) << "\n";
  for (unsigned int j = 0; j <= n_rows; ++j)
    for (unsigned int i = 0; i < n; ++i)
      out << j * n + i + 1 << " " << xs[i] << " " << double(j) / n_rows
          << " 0\n";
  out << "$EndNodes\n$Elements\n" << (n - 1) * (n_rows + 1) << "\n";
  unsigned int number = 1;
  for (unsigned int i = 1; i < n; ++i)
    out << number++ << " 1 2 1 1 " << i << " " << i + 1 << "\n";
  for (unsigned int j = 0; j < n_rows; ++j)
    for (unsigned int i = 1; i < n; ++i)
      {
        const unsigned int first = j * n + i;
        const unsigned int group = xs[i - 1] < -1e-9 ? 2 : 3;
        out << number++ << " 3 2 " << group << " 1 " << first << " "
            << first + 1 << " " << first + 1 + n << " " << first + n << "\n";
      }
  out << "$EndElements\n";
}



Parameters
parameters_of(const std::string &youngs_moduli,
              const std::vector<SceneEntry> &blade)
{
  std::vector<SceneEntry> entries = {
    {"Body", "Shape", "file", ""},
    {"Body", "File", "block.msh", ""},
    {"Material", "Young's modulus", youngs_moduli, ""},
    {"Material", "Poisson's ratio", "0.3", ""},
    {"Support", "Fixed faces", "foot", ""},
    {"Blade", "Drive", "travel", ""},
    {"Blade", "Direction", "0, -1", ""},
    {"Blade", "Thickness", "0.1", ""},
    {"Cut", "Surfaces", "between : left, right", ""},
    {"Division", "Release", "element row", ""},
    {"Yield", "Criterion", "energy release", ""}};
  entries.insert(entries.end(), blade.begin(), blade.end());
  return Parameters("test", entries, Scene<2>::declare);
}



/** A block that is cut half through, and its contact with a blade whose edge is
 * there. */
struct CutBlock
{
  CutBlock(const std::string &youngs_moduli,
           const std::vector<SceneEntry> &blade)
    : scene(parameters_of(youngs_moduli, blade))
    , body(scene, MPI_COMM_WORLD)
  {
    body.begin_cut(scene.cut.cuts[0]);
    body.split_nodes();
    for (unsigned int row = 0; row < n_split; ++row)
      body.release_row(row);
    contact = std::make_unique<CutContact<2>>(
      body, scene.blade.profile, body.model().discretization.zero_vector());
    motion.travel = double(n_split) / n_rows;
    path          = contact->path(n_split, 0, motion, nullptr);
  }

  double
  force() const
  {
    const auto forces = path->resultants();
    return forces.edge(motion.travel) + forces.flanks(motion.travel);
  }

  double
  shift() const
  {
    return path->shift(motion.travel);
  }

  const Scene<2> scene;
  CutBody<2> body;
  BladeMotion motion;
  std::unique_ptr<CutContact<2>> contact;
  std::unique_ptr<ContactPath<2>> path;
};


/** The force, and the shift. */
std::array<double, 2>
cut_by_wedge(const std::string &youngs_moduli, const std::string &guide)
{
  const CutBlock block(youngs_moduli,
                       {{"Blade", "Shape", "wedge", ""},
                        {"Blade", "Wedge angle", "20", ""},
                        {"Blade", "Guide", guide, ""}});
  return {{block.force(), block.shift()}};
}


void
test_guide()
{
  const auto held = cut_by_wedge("1", "fixed");
  const auto free = cut_by_wedge("1", "free");
  check_below(
    "free over guided, halves alike", std::abs(free[0] / held[0] - 1), 1e-9);
  check_below("its shift", std::abs(free[1]), 1e-9);
  const auto of_three = cut_by_wedge("left : 3; right : 1", "fixed");
  const auto to_right = cut_by_wedge("left : 3; right : 1", "free");
  const auto to_left  = cut_by_wedge("left : 1; right : 3", "free");
  std::cout << "force of stiffer halves: " << of_three[0] / held[0]
            << " guided, " << to_right[0] / held[0] << " free, shift "
            << to_right[1] << std::endl;
  check_below("mirrored",
              std::abs(to_left[1] / to_right[1] + 1) +
                std::abs(to_left[0] / to_right[0] - 1),
              1e-9);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    write_block();
    test_guide();
  });
}
