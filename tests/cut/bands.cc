// SPDX-License-Identifier: LGPL-2.1-or-later
// Rows as bands of faces: those of elements in straight layers are the element
// rows, and those of others are strips of the cut's true width.

#include <setsudan/simulation/cut_body.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "../parameters/check.h"
#include "../test_setup.h"
#include "block_file.h"

using namespace Setsudan;

using Entries = std::vector<SceneEntry>;

template <int dim>
Scene<dim>
make_scene(const Entries &entries, const std::string &release)
{
  Entries all = {{"Support",
                  dim == 3 ? "Fixed boxes" : "Fixed faces",
                  dim == 3 ? "0,0,0,10,10,0 : xyz" : "bottom",
                  ""},
                 {"Division", "Release", release, ""}};
  all.insert(all.end(), entries.begin(), entries.end());
  return Scene<dim>(Parameters("test", all, Scene<dim>::declare));
}

std::vector<unsigned int>
sorted(std::vector<unsigned int> list)
{
  std::sort(list.begin(), list.end());
  return list;
}

double
largest_difference(const std::vector<double> &a, const std::vector<double> &b)
{
  double largest = a.size() == b.size() ? 0 : 1;
  for (unsigned int i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/** Elements in straight layers. */
template <int dim>
void
test_layers(const std::string &name, const Entries &entries)
{
  const auto element_scene = make_scene<dim>(entries, "element row");
  const auto band_scene    = make_scene<dim>(entries, "face band");
  CutBody<dim> elements(element_scene, MPI_COMM_WORLD);
  CutBody<dim> bands(band_scene, MPI_COMM_WORLD);
  elements.begin_cut(element_scene.cut.cuts[0]);
  bands.begin_cut(band_scene.cut.cuts[0]);
  auto a        = elements.seam().rows();
  const auto &b = bands.seam().rows();
  // Nodes at the end that nothing holds are an element row, which opens
  // nothing.
  if (elements.area_of_row(a.size() - 1).area == 0)
    {
      auto &last = a[a.size() - 2].pairs;
      last.insert(last.end(), a.back().pairs.begin(), a.back().pairs.end());
      a.pop_back();
    }
  std::cout << name << ": " << b.size() << " bands" << std::endl;
  bool are_same = a.size() == b.size();
  double error  = 0;
  for (unsigned int row = 0; row < std::min(a.size(), b.size()); ++row)
    {
      are_same = are_same && sorted(a[row].pairs) == sorted(b[row].pairs) &&
                 a[row].front == b[row].front;
      error = std::max({error,
                        std::abs(a[row].depth - b[row].depth),
                        largest_difference(a[row].positions, b[row].positions),
                        largest_difference(a[row].lengths, b[row].lengths)});
    }
  check("  the same nodes and fronts", are_same);
  check_below("  depths, positions and lengths", error, 1e-12);
}

/** The nodes inside the cut y = 5 of a block are moved in it. */
dealii::Point<3>
position_askew(const std::array<unsigned int, 3> &at)
{
  const unsigned int i = at[0], k = at[2];
  return {10. * i / 8 + (i % 8 > 0 ? 0.3 * std::sin(3. * i + 5. * k) : 0.),
          5. * at[1],
          10. * k / 6 + (k % 6 > 0 ? 0.5 * std::sin(2. * i + 3. * k) : 0.)};
}

/** Elements that lie in no layers. */
void
test_askew(const std::string &refinement)
{
  write_block("askew.msh", {{8, 2, 6}}, position_askew);
  const auto scene =
    make_scene<3>({{"Body", "Shape", "file", ""},
                   {"Body", "File", "askew.msh", ""},
                   {"Cut", "Surfaces", "where : y - 5", ""},
                   {"Cut", "Refinement near cut", refinement, ""}},
                  "face band");
  CutBody<3> body(scene, MPI_COMM_WORLD);
  body.begin_cut(scene.cut.cuts[0]);
  const auto &rows  = body.seam().rows();
  const auto &pairs = body.seam().pairs();
  std::cout << "askew, refined by " << refinement << ": " << rows.size()
            << " bands, front of";
  std::set<unsigned int> unsplit;
  for (unsigned int p = 0; p < pairs.size(); ++p)
    unsplit.insert(p);
  bool is_unsplit = true, is_across = true;
  double area = 0, width = 0, length = 0;
  for (unsigned int row = 0; row < rows.size(); ++row)
    {
      const auto &front = rows[row].front;
      std::cout << " " << front.size();
      for (const unsigned int p : front)
        is_unsplit = is_unsplit && unsplit.count(p) > 0;
      is_across =
        is_across && std::abs(rows[row].positions.back() -
                              rows[row].positions.front() - 10) < 1e-12;
      for (const unsigned int p : rows[row].pairs)
        unsplit.erase(p);
      const double opened = body.area_of_row(row).area;
      area += opened;
      width      = std::max(width,
                       std::abs(opened / body.length_of_rows(row, 1) / 10 - 1));
      double sum = 0;
      for (const double of_node : rows[row].lengths)
        sum += of_node;
      length = std::max(length, 10 - sum);
    }
  std::cout << " nodes" << std::endl;
  check("  every node in a row", unsplit.empty());
  check("  fronts are not split", is_unsplit);
  check("  fronts go from side to side", is_across);
  check_below("  area", std::abs(area / 100 - 1), 1e-12);
  check_below("  width", width, 0.02);
  check_below("  length of the front beyond that of an edge", length, 1e-12);
}

int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    const auto on_block = [](const std::string &surface) {
      return Entries{{"Body", "Elements", "4,4,3", ""},
                     {"Cut", "Surfaces", surface, ""}};
    };
    const auto with = [](Entries entries, const Entries &more) {
      entries.insert(entries.end(), more.begin(), more.end());
      return entries;
    };
    const Entries plane = on_block("y:2");
    test_layers<3>("from above", plane);
    test_layers<3>("along x",
                   with(plane, {{"Blade", "Direction", "-1,0,0", ""}}));
    for (const std::string type : {"linear", "quadratic"})
      test_layers<3>(type, with(plane, {{"Body", "Element type", type, ""}}));
    test_layers<3>("refined",
                   with(plane, {{"Cut", "Refinement near cut", "1", ""}}));
    test_layers<3>("a slit", with(plane, {{"Cut", "Extent", "depth : 5", ""}}));
    test_layers<3>("inside",
                   with(plane, {{"Cut", "Extent", "box : 2,0,3,8,9,9", ""}}));
    test_layers<3>("closed",
                   on_block("where : max(abs(x - 5), abs(y - 5)) - 2.5"));
    test_layers<3>("running back",
                   on_block("where : min(y - 2.5, max(y - 7.5, "
                            "min(5 - x, max(2.5 - x, 5 - y))))"));
    test_layers<2>(
      "in the plane",
      {{"Body", "Elements", "2,4", ""}, {"Cut", "Surfaces", "x:1", ""}});
    test_askew("0");
    test_askew("1");
  });
}
