// SPDX-License-Identifier: LGPL-2.1-or-later
// The geometry of elements against the maps that they interpolate: volumes,
// points, normals and areas of straight, sheared and curved elements, and how
// well elements are shaped.

#include <setsudan/mesh/geometry.h>
#include <setsudan/mesh/nodes.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

/** A map of the reference cell that the shape functions contain: a matrix, and
 * x' += bulge y (1 - y) + swell x y (1 - y). */
template <int dim>
struct Map
{
  Tensor<2, dim> matrix = unit_symmetric_tensor<dim>();
  double bulge          = 0;
  double swell          = 0;

  Point<dim>
  operator()(const Point<dim> &p) const
  {
    Tensor<1, dim> point = p;
    point[0] += (bulge + swell * p[0]) * p[1] * (1 - p[1]);
    return Point<dim>(matrix * point);
  }

  Tensor<2, dim>
  gradient(const Point<dim> &p) const
  {
    Tensor<2, dim> inner = unit_symmetric_tensor<dim>();
    inner[0][0] += swell * p[1] * (1 - p[1]);
    inner[0][1] += (bulge + swell * p[0]) * (1 - 2 * p[1]);
    return matrix * inner;
  }
};


template <int dim>
ElementNodes<dim>
nodes_of(const Map<dim> &map)
{
  ElementNodes<dim> nodes;
  for (unsigned int node = 0; node < nodes.size(); ++node)
    nodes[node] = map(unit_point_of_node<dim>(node));
  return nodes;
}


/** A matrix of different lengths along the axes, and with shear. */
template <int dim>
Tensor<2, dim>
some_matrix(const double shear)
{
  Tensor<2, dim> matrix;
  for (unsigned int a = 0; a < dim; ++a)
    {
      matrix[a][a] = a + 2;
      for (unsigned int b = a + 1; b < dim; ++b)
        matrix[a][b] = shear * (a + b);
      for (unsigned int b = 0; b < a; ++b)
        matrix[a][b] = -shear / 2;
    }
  return matrix;
}


/** The point of the face's reference cell at a point of the cell's. */
template <int dim>
Point<dim>
on_face(const unsigned int face, const Point<dim - 1> &point)
{
  Point<dim> result;
  unsigned int i = 0;
  for (unsigned int d = 0; d < dim; ++d)
    result[d] = d == face / 2 ? face % 2 : point[i++];
  return result;
}


/** Nanson's formula: the normal times the area that a unit of the reference
 * face becomes. */
template <int dim>
Tensor<1, dim>
area_of_unit(const Map<dim> &map,
             const unsigned int face,
             const Point<dim> &point)
{
  const auto gradient = map.gradient(point);
  Tensor<1, dim> normal;
  normal[face / 2] = face % 2 == 1 ? 1 : -1;
  return determinant(gradient) * (transpose(invert(gradient)) * normal);
}


template <int dim>
void
test_points(const Map<dim> &map, const ElementNodes<dim> &nodes)
{
  const QGauss<dim> rule(4);
  double error = 0, gradient_error = 0;
  for (const auto &p : rule.get_points())
    {
      error = std::max(error, point_of_element(nodes, p).distance(map(p)));
      gradient_error =
        std::max(gradient_error,
                 (jacobian_of_element(nodes, p) - map.gradient(p)).norm());
    }
  check_below("  points", error, 1e-13);
  check_below("  Jacobians", gradient_error, 1e-12);
}


template <int dim>
void
test_faces(const Map<dim> &map, const ElementNodes<dim> &nodes)
{
  const QGauss<dim - 1> rule(6);
  double normal_error = 0, area_error = 0;
  Tensor<1, dim> closed;
  for (unsigned int face = 0; face < GeometryInfo<dim>::faces_per_cell; ++face)
    {
      Tensor<1, dim> area;
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const auto point  = on_face<dim>(face, rule.point(q));
          const auto scaled = area_of_unit(map, face, point);
          area += rule.weight(q) * scaled;
          normal_error = std::max(
            normal_error,
            (normal_of_face(nodes, face, point) - scaled / scaled.norm())
              .norm());
        }
      area_error =
        std::max(area_error, (area_vector_of_face(nodes, face) - area).norm());
      closed += area_vector_of_face(nodes, face);
    }
  check_below("  normals", normal_error, 1e-13);
  check_below("  area vectors", area_error, 1e-12);
  check_below("  their sum", closed.norm(), 1e-12);
}


template <int dim>
void
test(const std::string &name, const Map<dim> &map, const double volume)
{
  const auto nodes = nodes_of(map);
  std::cout << dim << "D, " << name << std::endl;
  check_below("  volume",
              std::abs(volume_of_element(nodes) - volume),
              1e-13 * std::abs(volume));
  test_points(map, nodes);
  test_faces(map, nodes);
}


/** Volumes by hand: the determinant of the matrix times the mean of 1 + swell
 * y (1 - y), which is 1 + swell / 6. */
template <int dim>
void
test()
{
  const auto boxed = some_matrix<dim>(0), sheared = some_matrix<dim>(0.5);
  const double box = dim == 2 ? 2 * 3 : 2 * 3 * 4;
  // | 2 .5 |        | 2    0.5  1   |
  // | -.25 3 |      | -.25 3    1.5 |
  //                 | -.25 -.25 4   |
  const double skew =
    dim == 2 ? 6.125
             : 2 * (12 + 0.375) - 0.5 * (-1 + 0.375) + 1 * (0.0625 + 0.75);
  test<dim>("straight", {boxed, 0, 0}, box);
  test<dim>("sheared", {sheared, 0, 0}, skew);
  test<dim>("bulging", {boxed, 0.3, 0}, box);
  test<dim>("swollen", {boxed, 0, 0.4}, box * (1 + 0.4 / 6));
  test<dim>("all of it", {sheared, -0.2, -0.3}, skew * (1 - 0.3 / 6));
}


/** By hand: the faces of a box, and a line that bulges by a parabola. */
void
test_by_hand()
{
  const auto box       = nodes_of(Map<3>{some_matrix<3>(0), 0, 0});
  const double areas[] = {12, 8, 6};
  double error         = 0;
  for (unsigned int face = 0; face < 6; ++face)
    {
      Tensor<1, 3> expected;
      expected[face / 2] = (face % 2 == 1 ? 1 : -1) * areas[face / 2];
      error =
        std::max(error, (area_vector_of_face(box, face) - expected).norm());
    }
  check_below("area vectors of a box of 2 x 3 x 4", error, 1e-13);
  // On the bulging side x = 1 + 0.3 y (1 - y), and on the other 0.3 y (1 - y).
  const auto bulging = nodes_of(Map<3>{unit_symmetric_tensor<3>(), 0.3, 0});
  std::cout << "middle of the bulging side ("
            << point_of_element(bulging, Point<3>(1, 0.5, 0.5)) << ")"
            << std::endl;
  Tensor<1, 3> slope({1, -0.3, 0});
  check_below(
    "normal at its end",
    (normal_of_face(bulging, 1, Point<3>(1, 0, 0)) - slope / slope.norm())
      .norm(),
    1e-14);
  check_below(
    "area vector",
    (area_vector_of_face(bulging, 1) - Tensor<1, 3>({1, 0, 0})).norm(),
    1e-14);
}


void
test_shape(const std::string &name, const double value, const double expected)
{
  check_below("scaled Jacobian, " + name, std::abs(value - expected), 1e-14);
}


/** The determinant over the cube of the longest line. */
template <int dim>
void
test_scaled_jacobian()
{
  const Tensor<2, dim> unit = unit_symmetric_tensor<dim>();
  const auto of             = [](const Map<dim> &map) {
    return scaled_jacobian(nodes_of(map));
  };
  std::cout << dim << "D" << std::endl;
  test_shape("cube", of({7. * unit, 0, 0}), 1);
  test_shape(
    "box", of({some_matrix<dim>(0), 0, 0}), dim == 2 ? 6. / 9 : 24. / 64);
  auto matrix  = unit;
  matrix[0][1] = 1;
  test_shape("sheared", of({matrix, 0, 0}), std::pow(0.5, dim / 2.));
  matrix[0][1] = 0;
  matrix[1][1] = 0;
  test_shape("flat", of({matrix, 0, 0}), 0);
  matrix[1][1] = -1;
  test_shape("inverted", of({matrix, 0, 0}), -1);
  // The determinant is smallest in the middle, or, where it swells, at the
  // ends; lines are measured from end to end.
  test_shape("shrunk", of({unit, 0, -0.4}), 0.9);
  test_shape("swollen", of({unit, 0, 0.4}), 1);

  // Middle nodes along x at a part of their lines: x = a x + (1 - a) x^2.
  for (const double part : {0.3, 0.25, 0.2})
    {
      auto nodes = nodes_of(Map<dim>());
      for (auto &node : nodes)
        if (node[0] == 0.5)
          node[0] = part;
      test_shape("middle node at " + std::to_string(part).substr(0, 4),
                 scaled_jacobian(nodes),
                 4 * part - 1);
    }
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test<2>();
    test<3>();
    test_by_hand();
    test_scaled_jacobian<2>();
    test_scaled_jacobian<3>();
  });
}
