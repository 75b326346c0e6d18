// SPDX-License-Identifier: LGPL-2.1-or-later
// The functions are the published ones (Zienkiewicz and Taylor, The Finite
// Element Method, serendipity family), on the cell [-1,1]^d:
//   3D vertex 1/8 (1+xx_i)(1+yy_i)(1+zz_i)(xx_i+yy_i+zz_i-2),
//   3D line   1/4 (1-x^2)(1+yy_i)(1+zz_i);
//   2D vertex 1/4 (1+xx_i)(1+yy_i)(xx_i+yy_i-1), line 1/2 (1-x^2)(1+yy_i).
// Their integrals are the nodal forces of uniform loads: in 3D a face pressure
// gives -1/12 (vertex) and 1/3 (line) of its resultant, a body force -1/8 and
// 1/6.

#include <setsudan/element/fe_q_serendipity.h>

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

/** The published function whose node is @p node, at @p p; both are given on
 * the unit cell. */
template <int dim>
double
published(const Point<dim> &node, const Point<dim> &p)
{
  double product = 1.;
  double sum     = 1. - dim;
  bool on_line   = false;
  for (unsigned int d = 0; d < dim; ++d)
    {
      const double xi_node = 2. * node[d] - 1.;
      const double xi      = 2. * p[d] - 1.;
      on_line              = on_line || xi_node == 0.;
      sum += xi * xi_node;
      product *= xi_node == 0. ? 1. - xi * xi : (1. + xi * xi_node) / 2.;
    }
  return on_line ? product : product * sum;
}


template <int dim>
void
test_functions()
{
  const FE_Q_Serendipity<dim> fe;
  const QGauss<dim> points(4);
  double error = 0.;
  for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    for (const Point<dim> &p : points.get_points())
      error = std::max(error,
                       std::abs(fe.shape_value(i, p) -
                                published(fe.unit_support_point(i), p)));
  check_below(std::to_string(dim) + "D functions", error, 1e-14);
}


/** The range of the integrals of functions @p begin to @p end - 1 over the
 * cell, or over the face z = 0. */
void
print_integrals(const std::string &name,
                const unsigned int begin,
                const unsigned int end,
                const bool on_face)
{
  const FE_Q_Serendipity<3> fe;
  const QGauss<3> cell_rule(3);
  double smallest = 1., largest = -1.;
  for (unsigned int i = begin; i < end; ++i)
    {
      if (on_face && !fe.has_support_on_face(i, 4))
        continue;
      double integral = 0.;
      for (unsigned int q = 0; q < cell_rule.size(); ++q)
        {
          Point<3> p = cell_rule.point(q);
          // Projected onto the face, the rule integrates over the face.
          if (on_face)
            p[2] = 0.;
          integral += fe.shape_value(i, p) * cell_rule.weight(q);
        }
      smallest = std::min(smallest, integral);
      largest  = std::max(largest, integral);
    }
  std::cout << name << ": " << smallest << " to " << largest << std::endl;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_functions<2>();
    test_functions<3>();
    print_integrals("pressure, vertices", 0, 8, true);
    print_integrals("pressure, lines", 8, 20, true);
    print_integrals("body force, vertices", 0, 8, false);
    print_integrals("body force, lines", 8, 20, false);
  });
}
