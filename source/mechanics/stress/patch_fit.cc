// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mechanics/stress/patch_fit.h>

#include <cmath>
#include <numeric>

namespace Setsudan
{
using namespace dealii;

namespace
{
// A monomial of which less than this part is new is left out.
constexpr double least_new_part = 1e-2;

template <int dim>
constexpr unsigned int n_monomials = dim == 2 ? 10 : 20;


double
norm(const std::vector<double> &values)
{
  return std::sqrt(
    std::inner_product(values.begin(), values.end(), values.begin(), 0.));
}
} // namespace


template <int dim>
PatchFit<dim>::PatchFit(const std::vector<Point<dim>> &samples,
                        const Point<dim> &center,
                        const double size)
  : center(center)
  , size(size)
{
  std::vector<std::vector<double>> columns(n_monomials<dim>,
                                           std::vector<double>(samples.size()));
  for (unsigned int s = 0; s < samples.size(); ++s)
    {
      const auto values = monomials_at(samples[s]);
      for (unsigned int m = 0; m < values.size(); ++m)
        columns[m][s] = values[m];
    }
  for (unsigned int m = 0; m < columns.size(); ++m)
    add(m, columns[m]);
}



template <int dim>
void
PatchFit<dim>::add(const unsigned int monomial, std::vector<double> at_samples)
{
  const double before = norm(at_samples);
  Function function{monomial, std::vector<double>(functions.size()), 0, {}};
  // Twice, since once leaves round-off of the size of what was removed.
  for (unsigned int repeat = 0; repeat < 2; ++repeat)
    for (unsigned int f = 0; f < functions.size(); ++f)
      {
        const auto &other       = functions[f].at_samples;
        const double projection = std::inner_product(
          other.begin(), other.end(), at_samples.begin(), 0.);
        function.projections[f] += projection;
        for (unsigned int s = 0; s < at_samples.size(); ++s)
          at_samples[s] -= projection * other[s];
      }
  function.norm = norm(at_samples);
  if (!(function.norm > least_new_part * before))
    return;
  for (double &value : at_samples)
    value /= function.norm;
  function.at_samples = std::move(at_samples);
  functions.push_back(std::move(function));
}



template <int dim>
unsigned int
PatchFit<dim>::n_functions() const
{
  return functions.size();
}



template <int dim>
std::vector<double>
PatchFit<dim>::weights_at(const Point<dim> &point) const
{
  const auto monomials = monomials_at(point);
  std::vector<double> values;
  for (const auto &function : functions)
    {
      double value = monomials[function.monomial];
      for (unsigned int f = 0; f < values.size(); ++f)
        value -= function.projections[f] * values[f];
      values.push_back(value / function.norm);
    }
  std::vector<double> weights(functions.front().at_samples.size(), 0.);
  for (unsigned int f = 0; f < functions.size(); ++f)
    for (unsigned int s = 0; s < weights.size(); ++s)
      weights[s] += values[f] * functions[f].at_samples[s];
  return weights;
}



template <int dim>
std::vector<double>
PatchFit<dim>::monomials_at(const Point<dim> &point) const
{
  const Tensor<1, dim> x     = (point - center) / size;
  std::vector<double> values = {1};
  for (unsigned int a = 0; a < dim; ++a)
    values.push_back(x[a]);
  for (unsigned int a = 0; a < dim; ++a)
    for (unsigned int b = 0; b <= a; ++b)
      values.push_back(x[a] * x[b]);
  for (unsigned int a = 0; a < dim; ++a)
    for (unsigned int b = 0; b <= a; ++b)
      for (unsigned int c = 0; c <= b; ++c)
        values.push_back(x[a] * x[b] * x[c]);
  return values;
}



template class PatchFit<2>;
template class PatchFit<3>;
} // namespace Setsudan
