// SPDX-License-Identifier: LGPL-2.1-or-later
// The matrices between a cell and its children: what is prolonged is the same
// polynomial on the children, and restricted back it is the same on the cell.

#include <setsudan/element/fe_q_serendipity.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

/** The function with these nodal @p values at @p p. */
template <int dim>
double
evaluate(const FiniteElement<dim> &fe,
         const Vector<double> &values,
         const Point<dim> &p)
{
  double sum = 0.;
  for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    sum += values(i) * fe.shape_value(i, p);
  return sum;
}


template <int dim>
void
test()
{
  const FE_Q_Serendipity<dim> fe;
  const QGauss<dim> points(3);
  double prolongation_error = 0.;
  double restriction_error  = 0.;
  Vector<double> values(fe.n_dofs_per_cell());
  Vector<double> child_values(fe.n_dofs_per_cell());
  Vector<double> restricted(fe.n_dofs_per_cell());
  for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    {
      values    = 0.;
      values(i) = 1.;
      Vector<double> collected(fe.n_dofs_per_cell());
      for (unsigned int child = 0;
           child < GeometryInfo<dim>::max_children_per_cell;
           ++child)
        {
          fe.get_prolongation_matrix(child).vmult(child_values, values);
          for (const Point<dim> &p : points.get_points())
            prolongation_error = std::max(
              prolongation_error,
              std::abs(evaluate(fe, child_values, p) -
                       evaluate(fe,
                                values,
                                GeometryInfo<dim>::child_to_cell_coordinates(
                                  p, child))));
          // Each child gives the values of the nodes that it touches.
          fe.get_restriction_matrix(child).vmult(restricted, child_values);
          for (unsigned int j = 0; j < restricted.size(); ++j)
            if (restricted(j) != 0.)
              collected(j) = restricted(j);
        }
      collected -= values;
      restriction_error = std::max(restriction_error, collected.linfty_norm());
    }
  const std::string name = std::to_string(dim) + "D ";
  check_below(name + "prolongation", prolongation_error, 1e-13);
  check_below(name + "restriction", restriction_error, 1e-13);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test<2>();
    test<3>();
  });
}
