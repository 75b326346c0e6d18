// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace Setsudan
{
/** A linear function of position. */
template <int dim>
struct LinearFunction
{
  dealii::Point<dim> center;
  double value = 0;
  dealii::Tensor<1, dim> slope;

  double
  operator()(const dealii::Point<dim> &point) const
  {
    return value + slope * (point - center);
  }
};

/** The linear (or constant) function that is nearest to values at weighted
 * points: with the points and weights of a quadrature, the L2 projection. */
template <int dim>
class LinearFit
{
public:
  /** @param weights greater than 0; the points do not lie in one plane.
   * @param is_constant whether the function is to have no slope. */
  LinearFit(const std::vector<dealii::Point<dim>> &points,
            const std::vector<double> &weights,
            const bool is_constant = false);

  LinearFunction<dim>
  operator()(const std::vector<double> &values) const;

private:
  const std::vector<dealii::Point<dim>> &points;
  const std::vector<double> &weights;
  /** The points' weighted mean, about which the function's mean is its value
   * and has nothing to do with its slope. */
  dealii::Point<dim> center;
  double volume = 0;
  /** 0, where the function is constant. */
  dealii::Tensor<2, dim> inverse_second_moment;
};
} // namespace Setsudan
