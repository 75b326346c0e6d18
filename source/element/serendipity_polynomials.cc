// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/element/serendipity_polynomials.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/geometry_info.h>
#include <deal.II/base/table_indices.h>

#include <cmath>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The @p order-th derivative of $x^e$. */
double
power_derivative(const unsigned int e, const unsigned int order, const double x)
{
  if (order > e)
    return 0.;
  double result = 1.;
  for (unsigned int k = 0; k < order; ++k)
    result *= e - k;
  for (unsigned int k = order; k < e; ++k)
    result *= x;
  return result;
}
} // namespace


template <int dim>
SerendipityPolynomials<dim>::SerendipityPolynomials()
  // The polynomial of the highest total degree is x^2 y z (2D: x^2 y).
  : ScalarPolynomialsBase<dim>(dim + 1, monomials().size())
  , exponents(monomials())
  , coefficients(this->n())
{
  const std::vector<Point<dim>> points = nodes();
  AssertDimension(points.size(), this->n());

  FullMatrix<double> vandermonde(this->n());
  for (unsigned int i = 0; i < this->n(); ++i)
    for (unsigned int m = 0; m < this->n(); ++m)
      vandermonde(i, m) =
        monomial_derivative(exponents[m], Exponents{}, points[i]);
  coefficients.invert(vandermonde);

  // On the unit cell all coefficients are integers: a vertex function is, for
  // example, (1-x)(1-y)(1-2x-2y), a line function 4x(1-x)(1-y). Without the
  // round-off of the inversion the functions are exactly 0 and 1 at the nodes.
  for (unsigned int m = 0; m < this->n(); ++m)
    for (unsigned int i = 0; i < this->n(); ++i)
      {
        const double integer = std::round(coefficients(m, i));
        Assert(std::abs(coefficients(m, i) - integer) < 1e-10,
               ExcInternalError());
        coefficients(m, i) = integer;
      }
}


template <int dim>
std::vector<Point<dim>>
SerendipityPolynomials<dim>::nodes()
{
  using Geometry = GeometryInfo<dim>;
  std::vector<Point<dim>> points;
  for (unsigned int v = 0; v < Geometry::vertices_per_cell; ++v)
    points.push_back(Geometry::unit_cell_vertex(v));
  for (unsigned int l = 0; l < Geometry::lines_per_cell; ++l)
    {
      const Point<dim> a = points[Geometry::line_to_cell_vertices(l, 0)];
      const Point<dim> b = points[Geometry::line_to_cell_vertices(l, 1)];
      points.push_back(a + 0.5 * (b - a));
    }
  return points;
}


template <int dim>
std::vector<typename SerendipityPolynomials<dim>::Exponents>
SerendipityPolynomials<dim>::monomials()
{
  constexpr unsigned int n_candidates = dim == 1 ? 3 : (dim == 2 ? 9 : 27);
  std::vector<Exponents> result;
  for (unsigned int candidate = 0; candidate < n_candidates; ++candidate)
    {
      // The digits of the candidate's number in base 3 are the exponents.
      Exponents e;
      unsigned int superlinear_degree = 0;
      unsigned int digits             = candidate;
      for (unsigned int d = 0; d < dim; ++d, digits /= 3)
        {
          e[d] = digits % 3;
          if (e[d] >= 2)
            superlinear_degree += e[d];
        }
      if (superlinear_degree <= 2)
        result.push_back(e);
    }
  return result;
}


template <int dim>
double
SerendipityPolynomials<dim>::monomial_derivative(const Exponents &exponents,
                                                 const Exponents &orders,
                                                 const Point<dim> &p)
{
  double product = 1.;
  for (unsigned int d = 0; d < dim; ++d)
    product *= power_derivative(exponents[d], orders[d], p[d]);
  return product;
}


template <int dim>
double
SerendipityPolynomials<dim>::mixed_derivative(const unsigned int i,
                                              const Exponents &orders,
                                              const Point<dim> &p) const
{
  AssertIndexRange(i, this->n());
  double sum = 0.;
  for (unsigned int m = 0; m < this->n(); ++m)
    if (coefficients(m, i) != 0.)
      sum += coefficients(m, i) * monomial_derivative(exponents[m], orders, p);
  return sum;
}


template <int dim>
template <int order>
Tensor<order, dim>
SerendipityPolynomials<dim>::all_derivatives(const unsigned int i,
                                             const Point<dim> &p) const
{
  using Result = Tensor<order, dim>;
  Result result;
  for (unsigned int c = 0; c < Result::n_independent_components; ++c)
    {
      const TableIndices<order> variables =
        Result::unrolled_to_component_indices(c);
      Exponents orders{};
      for (unsigned int k = 0; k < order; ++k)
        ++orders[variables[k]];
      result[variables] = mixed_derivative(i, orders, p);
    }
  return result;
}


template <int dim>
std::vector<double>
SerendipityPolynomials<dim>::mixed_derivatives(const Exponents &orders,
                                               const Point<dim> &p) const
{
  std::vector<double> results(this->n(), 0.);
  for (unsigned int m = 0; m < this->n(); ++m)
    {
      const double monomial = monomial_derivative(exponents[m], orders, p);
      if (monomial != 0.)
        for (unsigned int i = 0; i < this->n(); ++i)
          results[i] += coefficients(m, i) * monomial;
    }
  return results;
}


template <int dim>
template <int order>
void
SerendipityPolynomials<dim>::fill_derivatives(
  const Point<dim> &p,
  std::vector<Tensor<order, dim>> &results) const
{
  using Result = Tensor<order, dim>;
  Assert(results.empty() || results.size() == this->n(),
         ExcDimensionMismatch(results.size(), this->n()));
  if (results.empty())
    return;
  for (unsigned int c = 0; c < Result::n_independent_components; ++c)
    {
      const TableIndices<order> variables =
        Result::unrolled_to_component_indices(c);
      Exponents orders{};
      for (unsigned int k = 0; k < order; ++k)
        ++orders[variables[k]];
      const auto of_functions = mixed_derivatives(orders, p);
      for (unsigned int i = 0; i < results.size(); ++i)
        results[i][variables] = of_functions[i];
    }
}


template <int dim>
void
SerendipityPolynomials<dim>::evaluate(
  const Point<dim> &unit_point,
  std::vector<double> &values,
  std::vector<Tensor<1, dim>> &grads,
  std::vector<Tensor<2, dim>> &grad_grads,
  std::vector<Tensor<3, dim>> &third_derivatives,
  std::vector<Tensor<4, dim>> &fourth_derivatives) const
{
  if (!values.empty())
    values = mixed_derivatives(Exponents{}, unit_point);
  fill_derivatives(unit_point, grads);
  fill_derivatives(unit_point, grad_grads);
  fill_derivatives(unit_point, third_derivatives);
  fill_derivatives(unit_point, fourth_derivatives);
}


template <int dim>
double
SerendipityPolynomials<dim>::compute_value(const unsigned int i,
                                           const Point<dim> &p) const
{
  return mixed_derivative(i, Exponents{}, p);
}


template <int dim>
Tensor<1, dim>
SerendipityPolynomials<dim>::compute_1st_derivative(const unsigned int i,
                                                    const Point<dim> &p) const
{
  return all_derivatives<1>(i, p);
}


template <int dim>
Tensor<2, dim>
SerendipityPolynomials<dim>::compute_2nd_derivative(const unsigned int i,
                                                    const Point<dim> &p) const
{
  return all_derivatives<2>(i, p);
}


template <int dim>
Tensor<3, dim>
SerendipityPolynomials<dim>::compute_3rd_derivative(const unsigned int i,
                                                    const Point<dim> &p) const
{
  return all_derivatives<3>(i, p);
}


template <int dim>
Tensor<4, dim>
SerendipityPolynomials<dim>::compute_4th_derivative(const unsigned int i,
                                                    const Point<dim> &p) const
{
  return all_derivatives<4>(i, p);
}


template <int dim>
Tensor<1, dim>
SerendipityPolynomials<dim>::compute_grad(const unsigned int i,
                                          const Point<dim> &p) const
{
  return all_derivatives<1>(i, p);
}


template <int dim>
Tensor<2, dim>
SerendipityPolynomials<dim>::compute_grad_grad(const unsigned int i,
                                               const Point<dim> &p) const
{
  return all_derivatives<2>(i, p);
}


template <int dim>
std::string
SerendipityPolynomials<dim>::name() const
{
  return "SerendipityPolynomials";
}


template <int dim>
std::unique_ptr<ScalarPolynomialsBase<dim>>
SerendipityPolynomials<dim>::clone() const
{
  return std::make_unique<SerendipityPolynomials<dim>>(*this);
}


template class SerendipityPolynomials<1>;
template class SerendipityPolynomials<2>;
template class SerendipityPolynomials<3>;
} // namespace Setsudan
