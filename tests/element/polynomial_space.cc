// SPDX-License-Identifier: LGPL-2.1-or-later
// Of all monomials with exponents up to two, nodal interpolation reproduces
// those of superlinear degree at most two, and no others.

#include <setsudan/element/fe_q_serendipity.h>

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

template <int dim>
double
monomial(const std::array<unsigned int, dim> &exponents, const Point<dim> &p)
{
  double product = 1.;
  for (unsigned int d = 0; d < dim; ++d)
    product *= std::pow(p[d], exponents[d]);
  return product;
}


/** The interpolation error of a monomial at one point. */
template <int dim>
double
error_at(const FiniteElement<dim> &fe,
         const std::array<unsigned int, dim> &exponents,
         const Point<dim> &p)
{
  double sum = 0.;
  for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    sum +=
      monomial<dim>(exponents, fe.unit_support_point(i)) * fe.shape_value(i, p);
  return std::abs(sum - monomial<dim>(exponents, p));
}


template <int dim>
void
test()
{
  const FE_Q_Serendipity<dim> fe;
  const QGauss<dim> points(4);
  unsigned int n_reproduced = 0, n_others = 0;
  double largest_error  = 0.;
  double smallest_error = 1.;
  for (int k = 0; k < Utilities::pow(3, dim); ++k)
    {
      std::array<unsigned int, dim> exponents;
      unsigned int superlinear_degree = 0;
      for (unsigned int d = 0; d < dim; ++d)
        {
          exponents[d] = (k / Utilities::pow(3, d)) % 3;
          superlinear_degree += exponents[d] == 2 ? 2 : 0;
        }
      double error = 0.;
      for (const Point<dim> &p : points.get_points())
        error = std::max(error, error_at<dim>(fe, exponents, p));
      if (superlinear_degree <= 2)
        {
          ++n_reproduced;
          largest_error = std::max(largest_error, error);
        }
      else
        {
          ++n_others;
          smallest_error = std::min(smallest_error, error);
        }
    }
  const std::string name = std::to_string(dim) + "D ";
  check_below(name + std::to_string(n_reproduced) + " monomials, error",
              largest_error,
              1e-13);
  std::cout << name << n_others << " others, smallest error " << smallest_error
            << std::endl;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test<2>();
    test<3>();

    // x^2 y^2 is one at the node (1,1), 1/4 at the midpoints next to it, and
    // its interpolant is -1/4 + 2 * 1/4 * 1/2 = 0 in the centre.
    std::cout << "error of x^2 y^2 in the centre "
              << error_at<2>(FE_Q_Serendipity<2>(), {{2, 2}}, {0.5, 0.5})
              << std::endl;
  });
}
