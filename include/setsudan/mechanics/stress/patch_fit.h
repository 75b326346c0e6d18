// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <vector>

namespace Setsudan
{
/**
 * Least squares fit of a cubic polynomial to values at scattered points.
 * Monomials that the points cannot tell from those of lower degree are left
 * out, such as z^2 where there are two layers of points along z.
 */
template <int dim>
class PatchFit
{
public:
  /** @param samples the points; `center` and `size` of where they lie. */
  PatchFit(const std::vector<dealii::Point<dim>> &samples,
           const dealii::Point<dim> &center,
           const double size);

  /** How many monomials were kept. */
  unsigned int
  n_functions() const;

  /** The weights of the samples' values in the polynomial's value at a point.
   */
  std::vector<double>
  weights_at(const dealii::Point<dim> &point) const;

private:
  /** A polynomial that is orthogonal to those before it over the samples: a
   * monomial less its projections on them, divided by its norm. */
  struct Function
  {
    unsigned int monomial;
    std::vector<double> projections;
    double norm;
    std::vector<double> at_samples;
  };

  /** 1, x, y, z, x^2, ..., z^3 in the order of their degrees. */
  std::vector<double>
  monomials_at(const dealii::Point<dim> &point) const;

  void
  add(const unsigned int monomial, std::vector<double> at_samples);

  const dealii::Point<dim> center;
  const double size;
  std::vector<Function> functions;
};
} // namespace Setsudan
