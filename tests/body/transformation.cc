// SPDX-License-Identifier: LGPL-2.1-or-later
// How a body is brought to its place: scaled, rotated in turn, then moved.

#include <setsudan/body/transformation.h>

#include <cmath>

#include "../parameters/check.h"
#include "../test_setup.h"
#include "small_body.h"

using namespace Setsudan;
using namespace dealii;

/** Where the transformation brings a point. */
template <int dim>
Point<dim>
moved(const Assignments &assignments, const Point<dim> &point)
{
  Body<dim> body;
  body.mesh.vertices = {point};
  Transformation<dim>(parameters_of(assignments, Transformation<dim>::declare))
    .apply(body);
  return body.mesh.vertices[0];
}


template <int dim>
void
test(const Assignments &assignments,
     const Point<dim> &point,
     const Point<dim> &expected,
     const double tolerance)
{
  std::string name = std::to_string(dim) + "D";
  for (const auto &assignment : assignments)
    name += ", " + assignment;
  check_below(name, moved(assignments, point).distance(expected), tolerance);
}


/** Exactly: neither right angles nor factors are rounded. */
void
test_exact()
{
  using P = Point<3>;
  const P p(0.1, 0.2, 0.3);
  test<3>({}, p, p, 0);
  test<3>({"Body/Scale=2"}, p, P(0.2, 0.4, 0.6), 0);
  test<3>({"Body/Scale=1,2,4"}, p, P(0.1, 0.4, 1.2), 0);
  test<3>({"Body/Rotate=x : 90"}, p, P(0.1, -0.3, 0.2), 0);
  test<3>({"Body/Rotate=y : 90"}, p, P(0.3, 0.2, -0.1), 0);
  test<3>({"Body/Rotate=z : 90"}, p, P(-0.2, 0.1, 0.3), 0);
  test<3>({"Body/Rotate=z : -90"}, p, P(0.2, -0.1, 0.3), 0);
  test<3>({"Body/Rotate=z : 180"}, p, P(-0.1, -0.2, 0.3), 0);
  test<3>({"Body/Rotate=z : 270"}, p, P(0.2, -0.1, 0.3), 0);
  test<3>({"Body/Rotate=z : 3690"}, p, P(-0.2, 0.1, 0.3), 0);
  test<3>({"Body/Translate=0.5, 0, -1"}, p, P(0.6, 0.2, -0.7), 1e-15);
  test<2>({"Body/Scale=2,4"}, Point<2>(0.1, 0.2), Point<2>(0.2, 0.8), 0);
  test<2>({"Body/Rotate=z : 90"}, Point<2>(0.1, 0.2), Point<2>(-0.2, 0.1), 0);
}


/** Scaled before it is rotated, rotations in turn, moved last. */
void
test_order()
{
  using P = Point<3>;
  const P p(0.1, 0.2, 0.3);
  test<3>({"Body/Rotate=z : 90; x : 90"}, p, P(-0.2, -0.3, 0.1), 0);
  test<3>({"Body/Rotate=x : 90; z : 90"}, p, P(0.3, 0.1, 0.2), 0);
  test<3>({"Body/Translate=1,0,0", "Body/Rotate=z:90", "Body/Scale=2,1,1"},
          p,
          P(0.8, 0.2, 0.3),
          1e-15);
  const double c = std::cos(numbers::PI / 6), s = 0.5;
  test<3>({"Body/Rotate=z : 30"},
          p,
          P(0.1 * c - 0.2 * s, 0.1 * s + 0.2 * c, 0.3),
          1e-15);
  test<2>({"Body/Rotate=z : 10; z : 20"},
          Point<2>(0.1, 0.2),
          Point<2>(0.1 * c - 0.2 * s, 0.1 * s + 0.2 * c),
          1e-15);
}


/** The middle nodes of curved lines go with the vertices; numbers and groups
 * of the body stay. */
void
test_body()
{
  Body<2> body         = make_box<2>(Point<2>(2, 1), {{2, 1}});
  body.mesh.line_nodes = {CoarseMesh<2>::LineNodes(), {}};
  auto &of_first       = body.mesh.line_nodes[0];
  of_first[0]          = Point<2>(0.25, 0.5);
  const auto numbers   = body.node_numbers;
  const auto groups    = body.groups.size();
  Transformation<2>(
    parameters_of({"Body/Scale=2", "Body/Rotate=z:90", "Body/Translate=1,1"},
                  Transformation<2>::declare))
    .apply(body);
  std::cout << "a middle node at (" << body.mesh.line_nodes[0][0]
            << "), the last vertex at (" << body.mesh.vertices.back() << ")"
            << std::endl;
  check("the rest stays",
        body.node_numbers == numbers && body.groups.size() == groups &&
          body.box);
  // It is part of what a scene says of its body.
  const SmallBody<3> small({"Body/Size=1,1,1", "Body/Translate=1,2,3"});
  std::cout << "a box from (" << small.body.mesh.vertices.front() << ") to ("
            << small.body.mesh.vertices.back() << ")" << std::endl;
}


void
test_refusals()
{
  const auto refuse = [](const std::string &assignment) {
    print_refusal([&] { moved<3>({assignment}, Point<3>()); });
  };
  refuse("Body/Scale=0");
  refuse("Body/Scale=1, -1, 1");
  refuse("Body/Scale=1, 2");
  refuse("Body/Rotate=90");
  refuse("Body/Rotate=w : 90");
  refuse("Body/Rotate=xy : 90");
  refuse("Body/Rotate=z : 90, 45");
  refuse("Body/Rotate=z : right");
  print_refusal([] { moved<2>({"Body/Rotate=x : 90"}, Point<2>()); });
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_exact();
    test_order();
    test_body();
    test_refusals();
  });
}
