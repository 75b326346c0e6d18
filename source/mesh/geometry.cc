// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/qprojector.h>
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/element/serendipity_polynomials.h>
#include <setsudan/mesh/geometry.h>
#include <setsudan/parameters/lists.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Setsudan
{
using namespace dealii;

namespace
{
template <int dim>
const SerendipityPolynomials<dim> &
polynomials()
{
  static const SerendipityPolynomials<dim> polynomials;
  return polynomials;
}

/** The gradients of all shape functions at one point. */
template <int dim>
using ShapeGradients = std::array<Tensor<1, dim>, n_element_nodes<dim>>;

template <int dim>
ShapeGradients<dim>
shape_gradients(const Point<dim> &unit_point)
{
  ShapeGradients<dim> gradients;
  for (unsigned int i = 0; i < gradients.size(); ++i)
    gradients[i] = polynomials<dim>().compute_grad(i, unit_point);
  return gradients;
}

template <int dim>
Tensor<2, dim>
jacobian(const ElementNodes<dim> &nodes, const ShapeGradients<dim> &gradients)
{
  Tensor<2, dim> result;
  for (unsigned int i = 0; i < nodes.size(); ++i)
    result += outer_product(Tensor<1, dim>(nodes[i]), gradients[i]);
  return result;
}

/** Shape gradients at the points of a rule: computed once, since all elements
 * are asked at the same points. */
template <int dim>
std::vector<ShapeGradients<dim>>
tabulate(const std::vector<Point<dim>> &points)
{
  std::vector<ShapeGradients<dim>> table;
  for (const auto &point : points)
    table.push_back(shape_gradients(point));
  return table;
}

/** Cofactors times the unit normal of the reference face: the normal scaled
 * by how much area grows from the reference face (Nanson's formula). */
template <int dim>
Tensor<1, dim>
scaled_normal(const Tensor<2, dim> &jacobian, const unsigned int face)
{
  const unsigned int axis = face / 2;
  const double sign       = face % 2 == 1 ? 1. : -1.;
  Tensor<1, dim> normal;
  for (unsigned int d = 0; d < dim; ++d)
    if constexpr (dim == 2)
      normal[d] = (d == axis ? 1. : -1.) * jacobian[1 - d][1 - axis] * sign;
    else
      {
        const unsigned int r = (d + 1) % 3, s = (d + 2) % 3;
        const unsigned int a = (axis + 1) % 3, b = (axis + 2) % 3;
        normal[d] = sign * (jacobian[r][a] * jacobian[s][b] -
                            jacobian[r][b] * jacobian[s][a]);
      }
  return normal;
}
} // namespace


template <int dim>
Point<dim>
point_of_element(const ElementNodes<dim> &nodes, const Point<dim> &unit_point)
{
  Point<dim> point;
  for (unsigned int i = 0; i < nodes.size(); ++i)
    point += polynomials<dim>().compute_value(i, unit_point) *
             Tensor<1, dim>(nodes[i]);
  return point;
}



template <int dim>
Tensor<2, dim>
jacobian_of_element(const ElementNodes<dim> &nodes,
                    const Point<dim> &unit_point)
{
  return jacobian(nodes, shape_gradients(unit_point));
}



template <int dim>
Tensor<1, dim>
normal_of_face(const ElementNodes<dim> &nodes,
               const unsigned int face,
               const Point<dim> &unit_point)
{
  const auto normal =
    scaled_normal(jacobian_of_element(nodes, unit_point), face);
  return normal / normal.norm();
}



template <int dim>
double
area_element_of_face(const ElementNodes<dim> &nodes,
                     const unsigned int face,
                     const Point<dim> &unit_point)
{
  return scaled_normal(jacobian_of_element(nodes, unit_point), face).norm();
}



template <int dim>
Tensor<1, dim>
area_vector_of_face(const ElementNodes<dim> &nodes, const unsigned int face)
{
  static const std::vector<std::vector<ShapeGradients<dim>>> tables = []() {
    std::vector<std::vector<ShapeGradients<dim>>> tables;
    for (unsigned int f = 0; f < GeometryInfo<dim>::faces_per_cell; ++f)
      tables.push_back(
        tabulate(QProjector<dim>::project_to_face(
                   ReferenceCells::get_hypercube<dim>(), QGauss<dim - 1>(3), f)
                   .get_points()));
    return tables;
  }();
  const QGauss<dim - 1> rule(3);
  Tensor<1, dim> area;
  for (unsigned int q = 0; q < rule.size(); ++q)
    area +=
      rule.weight(q) * scaled_normal(jacobian(nodes, tables[face][q]), face);
  return area;
}



template <int dim>
double
volume_of_element(const ElementNodes<dim> &nodes)
{
  static const QGauss<dim> rule(3);
  static const auto table = tabulate(rule.get_points());
  double volume           = 0;
  for (unsigned int q = 0; q < rule.size(); ++q)
    volume += rule.weight(q) * determinant(jacobian(nodes, table[q]));
  return volume;
}



template <int dim>
Tensor<1, dim>
first_moment_of_element(const ElementNodes<dim> &nodes)
{
  static const QGauss<dim> rule(3);
  static const auto table = tabulate(rule.get_points());
  Tensor<1, dim> moment;
  for (unsigned int q = 0; q < rule.size(); ++q)
    moment += rule.weight(q) * determinant(jacobian(nodes, table[q])) *
              point_of_element(nodes, rule.point(q));
  return moment;
}



namespace
{
/** The lengths of the shortest and the longest straight line between the ends
 * of an element's lines. */
template <int dim>
std::pair<double, double>
extreme_lengths(const ElementNodes<dim> &nodes)
{
  double shortest = std::numeric_limits<double>::max(), longest = 0;
  for (unsigned int node = GeometryInfo<dim>::vertices_per_cell;
       node < nodes.size();
       ++node)
    {
      const auto ends     = vertices_of_node<dim>(node);
      const double length = nodes[ends[0]].distance(nodes[ends[1]]);
      shortest            = std::min(shortest, length);
      longest             = std::max(longest, length);
    }
  return {shortest, longest};
}
} // namespace



template <int dim>
std::string
text_of(const Point<dim> &point)
{
  std::string text;
  for (unsigned int d = 0; d < dim; ++d)
    text += (d == 0 ? "(" : ", ") + short_text(point[d]);
  return text + ")";
}



template <int dim>
double
coordinate_tolerance(const ElementNodes<dim> &nodes)
{
  return 1e-6 * extreme_lengths<dim>(nodes).first;
}



template <int dim>
double
scaled_jacobian(const ElementNodes<dim> &nodes)
{
  static const auto table = []() {
    auto points = QGauss<dim>(3).get_points();
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      points.push_back(unit_point_of_node<dim>(node));
    return tabulate(points);
  }();
  double smallest = std::numeric_limits<double>::max();
  for (const auto &gradients : table)
    smallest = std::min(smallest, determinant(jacobian(nodes, gradients)));
  return smallest / std::pow(extreme_lengths<dim>(nodes).second, dim);
}



template Point<2>
point_of_element(const ElementNodes<2> &, const Point<2> &);
template Point<3>
point_of_element(const ElementNodes<3> &, const Point<3> &);
template Tensor<2, 2>
jacobian_of_element(const ElementNodes<2> &, const Point<2> &);
template Tensor<2, 3>
jacobian_of_element(const ElementNodes<3> &, const Point<3> &);
template Tensor<1, 2>
normal_of_face(const ElementNodes<2> &, const unsigned int, const Point<2> &);
template Tensor<1, 3>
normal_of_face(const ElementNodes<3> &, const unsigned int, const Point<3> &);
template double
area_element_of_face(const ElementNodes<2> &,
                     const unsigned int,
                     const Point<2> &);
template Tensor<1, 2>
area_vector_of_face(const ElementNodes<2> &, const unsigned int);
template double
area_element_of_face(const ElementNodes<3> &,
                     const unsigned int,
                     const Point<3> &);
template Tensor<1, 3>
area_vector_of_face(const ElementNodes<3> &, const unsigned int);
template double
volume_of_element(const ElementNodes<2> &);
template double
volume_of_element(const ElementNodes<3> &);
template Tensor<1, 2>
first_moment_of_element(const ElementNodes<2> &);
template Tensor<1, 3>
first_moment_of_element(const ElementNodes<3> &);
template std::string
text_of(const Point<2> &);
template std::string
text_of(const Point<3> &);
template double
coordinate_tolerance(const ElementNodes<2> &);
template double
coordinate_tolerance(const ElementNodes<3> &);
template double
scaled_jacobian(const ElementNodes<2> &);
template double
scaled_jacobian(const ElementNodes<3> &);
} // namespace Setsudan
