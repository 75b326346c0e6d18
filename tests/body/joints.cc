// SPDX-License-Identifier: LGPL-2.1-or-later
// Where bodies touch themselves without being joined, and where parts are
// joined by lines and points only.

#include <setsudan/body/gmsh/gmsh_file.h>
#include <setsudan/body/joints.h>

#include "../test_setup.h"
#include "gmsh_text.h"

using namespace Setsudan;
using namespace dealii;

template <int dim>
void
print_joints(const std::string &name, const std::string &text)
{
  const auto body = read_gmsh_file<dim>(write_text("joints.msh", text));
  std::cout << name << ":" << std::endl;
  for (const auto &sentence : describe_joints(body, find_joints(body)))
    std::cout << "  " << sentence << std::endl;
}


/** Add a cube of n x n x n elements between two corners, with nodes of its own
 * from `first` on. */
void
add_cube(TextMesh &mesh,
         const Point<3> &lower,
         const Point<3> &upper,
         const unsigned int n,
         const unsigned long first)
{
  const auto number =
    [&](const unsigned int i, const unsigned int j, const unsigned int k) {
      return first + i + (n + 1) * (j + (n + 1) * k);
    };
  for (unsigned int k = 0; k <= n; ++k)
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        mesh.nodes[number(i, j, k)] = {
          {lower[0] + (upper[0] - lower[0]) * i / n,
           lower[1] + (upper[1] - lower[1]) * j / n,
           lower[2] + (upper[2] - lower[2]) * k / n}};
  for (unsigned int k = 0; k < n; ++k)
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        mesh.elements.push_back({mesh.elements.size() + 1,
                                 5,
                                 1,
                                 1,
                                 {number(i, j, k),
                                  number(i + 1, j, k),
                                  number(i + 1, j + 1, k),
                                  number(i, j + 1, k),
                                  number(i, j, k + 1),
                                  number(i + 1, j, k + 1),
                                  number(i + 1, j + 1, k + 1),
                                  number(i, j + 1, k + 1)}});
}


/** Two cubes, one on the other, which have n and m elements a side, and may be
 * apart. */
TextMesh
stacked(const unsigned int n, const unsigned int m, const double gap = 0)
{
  TextMesh mesh;
  add_cube(mesh, {0, 0, 0}, {1, 1, 1}, n, 1);
  add_cube(mesh, {0, 0, 1 + gap}, {1, 1, 2}, m, 1001);
  return mesh;
}


/** Give a node's place in the second element to another node. */
TextMesh
joined(TextMesh mesh, const unsigned long node, const unsigned long other)
{
  for (auto &element : mesh.elements)
    std::replace(element.nodes.begin(), element.nodes.end(), node, other);
  mesh.nodes.erase(node);
  return mesh;
}


void
test_space()
{
  print_joints<3>("joined", two_cubes().text());
  print_joints<3>("apart", stacked(2, 2, 0.01).text());
  print_joints<3>("not joined", stacked(2, 2).text());
  auto quadratic = stacked(2, 2);
  quadratic.make_quadratic(3000);
  print_joints<3>("not joined, quadratic", quadratic.text());
  print_joints<3>("finer above", stacked(2, 4).text());
  print_joints<3>("finer below", stacked(3, 1).text());
  const auto at_point = joined(stacked(1, 1), 1001, 5);
  print_joints<3>("joined at a point, double elsewhere", at_point.text());
  TextMesh at_line;
  add_cube(at_line, {0, 0, 0}, {1, 1, 1}, 1, 1);
  add_cube(at_line, {1, 0, 1}, {2, 1, 2}, 1, 11);
  print_joints<3>("joined at a line",
                  joined(joined(at_line, 11, 6), 13, 8).text());
  auto slit                 = two_cubes();
  slit.nodes[20]            = slit.nodes[5];
  slit.nodes[21]            = slit.nodes[6];
  slit.elements[1].nodes[0] = 20;
  slit.elements[1].nodes[1] = 21;
  print_joints<3>("a slit", slit.text());
}


/** A ring in a ring, of n and m elements around, with middle nodes. */
TextMesh
rings(const unsigned int n, const unsigned int m)
{
  TextMesh mesh;
  const auto add = [&](const double inner,
                       const double outer,
                       const unsigned int n,
                       const unsigned long first) {
    const auto node = [&](const double radius, const double i) {
      const double angle = 2 * numbers::PI * i / n;
      const unsigned long number =
        first + std::lround(100 * radius) * 100 + std::lround(2 * i) % (2 * n);
      mesh.nodes[number] = {
        {radius * std::cos(angle), radius * std::sin(angle), 0.}};
      return number;
    };
    const double middle = (inner + outer) / 2;
    for (unsigned int i = 0; i < n; ++i)
      mesh.elements.push_back({mesh.elements.size() + 1,
                               16,
                               1,
                               1,
                               {node(inner, i),
                                node(outer, i),
                                node(outer, i + 1),
                                node(inner, i + 1),
                                node(middle, i),
                                node(outer, i + 0.5),
                                node(middle, i + 1),
                                node(inner, i + 0.5)}});
  };
  add(1, 2, n, 1);
  add(2, 3, m, 100001);
  return mesh;
}


void
test_plane()
{
  print_joints<2>("squares", two_squares().text());
  auto two                 = two_squares();
  two.nodes[12]            = two.nodes[2];
  two.elements[1].nodes[0] = 12;
  print_joints<2>("squares that share a point", two.text());
  print_joints<2>("rings alike", rings(24, 24).text());
  print_joints<2>("rings that differ", rings(24, 32).text());
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_space();
    test_plane();
  });
}
