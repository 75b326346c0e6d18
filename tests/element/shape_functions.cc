// SPDX-License-Identifier: LGPL-2.1-or-later
// Each function is one at its node and zero at the others; they sum to one
// everywhere; their derivatives are those that differences give.

#include <setsudan/element/fe_q_serendipity.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

template <int dim>
std::vector<Point<dim>>
sample_points()
{
  std::vector<Point<dim>> points;
  for (unsigned int k = 0; k < 7; ++k)
    {
      Point<dim> p;
      for (unsigned int d = 0; d < dim; ++d)
        p[d] = std::fmod(0.137 + 0.618 * k + 0.271 * d * (k + 1), 1.);
      points.push_back(p);
    }
  return points;
}


template <int dim>
double
kronecker_error(const FiniteElement<dim> &fe)
{
  double error = 0.;
  for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    for (unsigned int j = 0; j < fe.n_dofs_per_cell(); ++j)
      error = std::max(error,
                       std::abs(fe.shape_value(i, fe.unit_support_point(j)) -
                                (i == j ? 1. : 0.)));
  return error;
}


template <int dim>
double
partition_error(const FiniteElement<dim> &fe)
{
  double error = 0.;
  for (const Point<dim> &p : sample_points<dim>())
    {
      double sum = 0.;
      Tensor<1, dim> gradient;
      for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
        {
          sum += fe.shape_value(i, p);
          gradient += fe.shape_grad(i, p);
        }
      error = std::max({error, std::abs(sum - 1.), gradient.norm()});
    }
  return error;
}


/** The largest difference between @p derivative and the central difference of
 * @p function. The functions are at most quadratic in each variable, for which
 * central differences are exact with any step. */
template <int dim, typename FunctionType, typename DerivativeType>
double
difference_error(const FiniteElement<dim> &fe,
                 const FunctionType &function,
                 const DerivativeType &derivative)
{
  constexpr double h = 0.5;
  double error       = 0.;
  for (const Point<dim> &p : sample_points<dim>())
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        {
          const Tensor<1, dim> step = h * Point<dim>::unit_vector(d);
          auto difference           = function(i, p + step);
          difference -= function(i, p - step);
          difference /= 2. * h;
          difference -= derivative(i, p)[d];
          error = std::max(error, static_cast<double>(difference.norm()));
        }
  return error;
}


template <int dim>
void
test()
{
  const FE_Q_Serendipity<dim> fe;
  const std::string name = std::to_string(dim) + "D ";

  const auto value = [&](const unsigned int i, const Point<dim> &p) {
    return Tensor<0, dim>(fe.shape_value(i, p));
  };
  const auto first = [&](const unsigned int i, const Point<dim> &p) {
    return fe.shape_grad(i, p);
  };
  const auto second = [&](const unsigned int i, const Point<dim> &p) {
    return fe.shape_grad_grad(i, p);
  };
  const auto third = [&](const unsigned int i, const Point<dim> &p) {
    return fe.shape_3rd_derivative(i, p);
  };
  const auto fourth = [&](const unsigned int i, const Point<dim> &p) {
    return fe.shape_4th_derivative(i, p);
  };

  check_below(name + "Kronecker property", kronecker_error(fe), 0.);
  check_below(name + "partition of unity", partition_error(fe), 1e-13);
  check_below(name + "gradients", difference_error(fe, value, first), 1e-12);
  check_below(name + "hessians", difference_error(fe, first, second), 1e-12);
  check_below(
    name + "third derivatives", difference_error(fe, second, third), 1e-12);
  check_below(
    name + "fourth derivatives", difference_error(fe, third, fourth), 1e-12);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test<2>();
    test<3>();
  });
}
