// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <utility>

namespace Setsudan
{
/** The principal axes of a right Cauchy-Green tensor C, its logarithmic strain
 * 1/2 ln C, and derivatives by C of what is a function of that. */
class PrincipalAxes
{
public:
  using Symmetric = dealii::SymmetricTensor<2, 3>;

  explicit PrincipalAxes(const Symmetric &C);

  Symmetric
  logarithm() const;

  /** The a-th principal value of the logarithmic strain. */
  double
  logarithm(const unsigned int a) const;

  /** The unit vector of a principal axis. */
  const dealii::Tensor<1, 3> &
  direction(const unsigned int a) const
  {
    return pairs[a].second;
  }

  /** The second Piola-Kirchhoff stress of one that is conjugate to the
   * logarithmic strain. */
  Symmetric
  stress(const Symmetric &of_logarithm) const;

  /** Twice the derivative by C of that.
   *
   * @param stress conjugate to the logarithmic strain.
   * @param of_logarithm its derivative by that. */
  dealii::SymmetricTensor<4, 3>
  tangent(const Symmetric &stress,
          const dealii::SymmetricTensor<4, 3> &of_logarithm) const;

private:
  using SecondDifferences = std::array<std::array<std::array<double, 3>, 3>, 3>;

  /** Stress times the second derivative of the logarithm along two tensors of
   * the basis (Daleckii and Krein 1965). */
  static double
  curvature(const std::array<std::array<double, 3>, 3> &stress,
            const SecondDifferences &second,
            const unsigned int i,
            const unsigned int j);

  double
  square(const unsigned int i) const
  {
    return pairs[i].first;
  }

  const std::array<std::pair<double, dealii::Tensor<1, 3>>, 3> pairs;
  /** Of symmetric tensors in these axes. */
  std::array<Symmetric, 6> basis;
  /** The first divided differences of the logarithm. */
  std::array<double, 6> first;
};
} // namespace Setsudan
