// SPDX-License-Identifier: LGPL-2.1-or-later
// Regions: groups have the points of what is in them and of its boundary, boxes
// those between two corners, and lists of nodes these nodes only.

#include <setsudan/body/region.h>

#include <cmath>
#include <functional>

#include "../parameters/check.h"
#include "../test_setup.h"
#include "detach.h"
#include "small_body.h"

using namespace Setsudan;
using namespace dealii;

/** A body of 2 x 2 (x 2) cubes of edge 1. */
template <int dim>
Body<dim>
cubes()
{
  return SmallBody<dim>({dim == 3 ? "Body/Elements=2,2,2" : "Body/Elements=2,2",
                         dim == 3 ? "Body/Size=2,2,2" : "Body/Size=2,2"})
    .body;
}


/** At all points whose reference coordinates are quarters, as every element
 * has them. */
template <int dim>
void
compare(const std::string &name,
        const Body<dim> &body,
        const Region<dim> &region,
        const std::function<bool(const Point<dim> &)> &expected)
{
  unsigned int n_inside = 0, n_wrong = 0;
  for (unsigned int cell = 0; cell < body.mesh.cells.size(); ++cell)
    for (unsigned int i = 0; i < std::pow(5, dim); ++i)
      {
        Point<dim> unit_point;
        for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= 5)
          unit_point[d] = (rest % 5) / 4.;
        const Point<dim> point =
          body.mesh.vertices[body.mesh.cells[cell].vertices[0]] +
          (unit_point - Point<dim>());
        const bool is_inside = region.contains(body, cell, unit_point);
        n_inside += is_inside;
        n_wrong += is_inside != expected(point);
      }
  std::cout << dim << "D, " << name << ": " << n_inside << " points, "
            << n_wrong << " wrong" << std::endl;
}


template <int dim>
void
test_groups()
{
  Body<dim> body = cubes<dim>();
  // The elements of the first row, two lines, a vertex, and nothing; vertices
  // are numbered x fastest.
  const auto line = [](const unsigned int a, const unsigned int b) {
    return make_entity_key(std::vector<unsigned int>{a, b});
  };
  body.groups.push_back({"row", 1, dim, {0, 1}, {}});
  body.groups.push_back({"lines", 2, 1, {}, {line(0, 1), line(4, 1)}});
  body.groups.push_back(
    {"vertex", 3, 0, {}, {make_entity_key(std::vector<unsigned int>{4})}});
  body.groups.push_back({"none", 4, dim, {}, {}});
  const auto region = [&](const std::vector<std::string> &names) {
    std::vector<const Group *> groups;
    for (const auto &name : names)
      for (const Group *group : find_groups(body.groups, name))
        groups.push_back(group);
    return Region<dim>(body, groups);
  };
  using P = Point<dim>;
  // Whether y and z, where there is one, are 0.
  const auto low = [](const P &p) { return p[dim - 1] == 0; };
  const auto is  = [](const P &p, const double x, const double y) {
    return p[0] == x && p[1] == y && (dim == 2 || p[dim - 1] == 0);
  };

  compare<dim>(
    "right", body, region({"right"}), [](const P &p) { return p[0] == 2; });
  compare<dim>("left and top", body, region({"left", "top"}), [](const P &p) {
    return p[0] == 0 || p[dim - 1] == 2;
  });
  compare<dim>("row", body, region({"row"}), [](const P &p) {
    return p[1] <= 1 && p[dim - 1] <= 1;
  });
  compare<dim>("row and left", body, region({"row", "left"}), [](const P &p) {
    return (p[1] <= 1 && p[dim - 1] <= 1) || p[0] == 0;
  });
  compare<dim>("lines", body, region({"lines"}), [&](const P &p) {
    return (dim == 2 || low(p)) &&
           ((p[0] <= 1 && p[1] == 0) || (p[0] == 1 && p[1] <= 1));
  });
  compare<dim>("vertex", body, region({"vertex"}), [&](const P &p) {
    return is(p, 1, 1);
  });
  compare<dim>("none", body, region({"none"}), [](const P &) { return false; });
  compare<dim>("no group", body, region({}), [](const P &) { return false; });
}


template <int dim>
void
test_boxes()
{
  const Body<dim> body = cubes<dim>();
  using P              = Point<dim>;
  P lower, upper;
  for (unsigned int d = 0; d < dim; ++d)
    {
      lower[d] = 0.25 * d;
      upper[d] = 1.3;
    }
  compare<dim>("box", body, Region<dim>(lower, upper), [&](const P &p) {
    bool inside = true;
    for (unsigned int d = 0; d < dim; ++d)
      inside = inside && p[d] >= lower[d] && p[d] <= upper[d];
    return inside;
  });
  compare<dim>("point", body, Region<dim>(P(), P()), [](const P &p) {
    return p.norm() == 0;
  });
}


/** Of two elements in a row: the paper's numbers are nodes, and nothing between
 * them is. */
template <int dim>
void
test_nodes()
{
  const Body<dim> body =
    SmallBody<dim>({dim == 3 ? "Body/Elements=2,1,1" : "Body/Elements=2,1",
                    dim == 3 ? "Body/Size=2,1,1" : "Body/Size=2,1"})
      .body;
  using P = Point<dim>;
  compare<dim>("nodes",
               body,
               Region<dim>(std::set<unsigned int>{0, 2, 3}),
               [](const P &p) {
                 return p == P() || p == P::unit_vector(0) ||
                        p == 1.5 * P::unit_vector(0);
               });
}


/** Where a body was cut, both sides belong to the same regions: they are asked
 * by element and point of the uncut body. And a curved body has its points
 * where its nodes are. */
void
test_curved()
{
  Body<2> body = cubes<2>();
  for (unsigned int cell = 0; cell < 4; ++cell)
    {
      body.mesh.line_nodes.emplace_back();
      for (unsigned int line = 0; line < 4; ++line)
        {
          const auto ends = vertices_of_node<2>(4 + line);
          const auto a =
            body.mesh.vertices[body.mesh.cells[cell].vertices[ends[0]]];
          const auto b =
            body.mesh.vertices[body.mesh.cells[cell].vertices[ends[1]]];
          const Point<2> middle = a + (b - a) / 2;
          body.mesh.line_nodes.back()[line] =
            middle + Point<2>(0, 0.1 * std::sin(numbers::PI * middle[0]));
        }
    }
  // At x = 0.5 all points lie 0.1 higher than in the straight body.
  const Region<2> box(Point<2>(0.4, 1.05), Point<2>(0.6, 1.15));
  check("curved line", box.contains(body, 0, Point<2>(0.5, 1)));
  check("seen from above", box.contains(body, 2, Point<2>(0.5, 0)));
  check("its end", !box.contains(body, 0, Point<2>(1, 1)));
  check("below it", !box.contains(body, 0, Point<2>(0.5, 0.75)));
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_groups<2>();
    test_groups<3>();
    test_boxes<2>();
    test_boxes<3>();
    test_nodes<2>();
    test_nodes<3>();
    test_curved();
  });
}
