// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacements that are known exactly, and the body forces that hold them.
#pragma once

#include <deal.II/base/function.h>
#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <cmath>
#include <vector>

#include "small_elasticity.h"

namespace Setsudan
{
using namespace dealii;

/** A polynomial displacement, $u_i = a_i \cdot x + 1/2\, x \cdot H_i x$, with
 * arbitrary coefficients. */
template <int dim>
class PolynomialDisplacement : public Function<dim>
{
public:
  /** The second derivatives are multiplied by @p curvature: zero makes the
   * displacement linear. */
  PolynomialDisplacement(const double curvature)
    : Function<dim>(dim)
  {
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        {
          slopes[i][j] = 0.3 + 0.2 * i - 0.1 * j * j;
          for (unsigned int k = 0; k <= j; ++k)
            hessians[i][j][k] = curvature * (0.4 - 0.3 * i + 0.2 * j * k);
        }
  }

  double
  value(const Point<dim> &p, const unsigned int component) const override
  {
    return slopes[component] * p + 0.5 * (p * (hessians[component] * p));
  }

  /** The body force $-\nabla\cdot\sigma$, which is constant. */
  std::vector<double>
  body_force(const SmallMaterial &material) const
  {
    std::vector<double> force(dim, 0.);
    for (unsigned int i = 0; i < dim; ++i)
      {
        force[i] -= material.mu * trace(hessians[i]);
        for (unsigned int j = 0; j < dim; ++j)
          force[i] -= (material.lambda + material.mu) * hessians[j][j][i];
      }
    return force;
  }

private:
  std::array<Tensor<1, dim>, dim> slopes;
  std::array<SymmetricTensor<2, dim>, dim> hessians;
};

/** The displacement $u = a \sin(k\cdot x)$, with fixed a and k. */
template <int dim>
class WaveDisplacement : public Function<dim>
{
public:
  WaveDisplacement()
    : Function<dim>(dim)
  {
    for (unsigned int d = 0; d < dim; ++d)
      {
        amplitude[d]   = 1. - 0.4 * d;
        wave_vector[d] = 1. + 0.25 * d;
      }
  }

  double
  value(const Point<dim> &p, const unsigned int component) const override
  {
    return amplitude[component] * std::sin(wave_vector * p);
  }

  Tensor<1, dim> amplitude;
  Tensor<1, dim> wave_vector;
};

/** The body force $-\nabla\cdot\sigma = \mu |k|^2 u + (\lambda+\mu) k
 * (k\cdot u)$ of a WaveDisplacement, the same wave with another amplitude. */
template <int dim>
WaveDisplacement<dim>
wave_force(const WaveDisplacement<dim> &wave, const SmallMaterial &material)
{
  const Tensor<1, dim> &k     = wave.wave_vector;
  WaveDisplacement<dim> force = wave;
  force.amplitude             = material.mu * k.norm_square() * wave.amplitude +
                    (material.lambda + material.mu) * (k * wave.amplitude) * k;
  return force;
}
} // namespace Setsudan
