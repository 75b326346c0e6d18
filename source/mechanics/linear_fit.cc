// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mechanics/linear_fit.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
LinearFit<dim>::LinearFit(const std::vector<Point<dim>> &points,
                          const std::vector<double> &weights,
                          const bool is_constant)
  : points(points)
  , weights(weights)
{
  AssertDimension(points.size(), weights.size());
  // Relative to one of the points, so that a body far from the origin keeps
  // its digits.
  Tensor<1, dim> first_moment;
  for (unsigned int q = 0; q < points.size(); ++q)
    {
      volume += weights[q];
      first_moment += weights[q] * (points[q] - points[0]);
    }
  center = points[0] + first_moment / volume;
  Tensor<2, dim> second_moment;
  for (unsigned int q = 0; q < points.size(); ++q)
    second_moment +=
      weights[q] * outer_product(points[q] - center, points[q] - center);
  if (!is_constant)
    inverse_second_moment = invert(second_moment);
}



template <int dim>
LinearFunction<dim>
LinearFit<dim>::operator()(const std::vector<double> &values) const
{
  LinearFunction<dim> function{center, 0, {}};
  Tensor<1, dim> moment;
  for (unsigned int q = 0; q < points.size(); ++q)
    {
      function.value += weights[q] * values[q] / volume;
      moment += weights[q] * values[q] * (points[q] - center);
    }
  function.slope = inverse_second_moment * moment;
  return function;
}



template class LinearFit<2>;
template class LinearFit<3>;
} // namespace Setsudan
