// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// For batch_kernel.cc alone, like quadratic_grid.h.

#include <setsudan/kernel/quadratic_grid.h>
#include <setsudan/kernel/stiffness_kernel.h>

namespace Setsudan
{
namespace SETSUDAN_KIND
{
namespace
{
/** The gradient of the reference coordinates at a point. */
template <int dim, bool uniform>
struct Gradients
{
  const double *const values;

  Lanes
  operator()(const int point, const int r, const int direction) const
  {
    const int i = (point * dim + r) * dim + direction;
    if constexpr (uniform)
      return values[i] - Lanes{};
    else
      return reinterpret_cast<const Lanes *>(values)[i];
  }
};



/** Functions' gradients at a point, times the root of weight and volume. */
template <int dim, bool uniform>
inline void
function_gradients(const Gradients<dim, uniform> gradients,
                   const double *const reference,
                   const int n_functions,
                   const int q,
                   Lanes (*const g)[dim])
{
  for (int a = 0; a < n_functions; ++a)
    for (int d = 0; d < dim; ++d)
      {
        g[a][d] = Lanes{};
        for (int r = 0; r < dim; ++r)
          g[a][d] +=
            reference[(q * n_functions + a) * dim + r] * gradients(q, r, d);
      }
}



/** What two functions' gradients give at one point, but for the dilatation. */
template <int dim>
inline Lanes
distortion(const Lanes (&g)[dim],
           const Lanes (&h)[dim],
           const int c,
           const int d)
{
  Lanes sum = g[d] * h[c];
  if (c == d)
    for (int e = 0; e < dim; ++e)
      sum += g[e] * h[e];
  return sum;
}



/** See StiffnessKernel::integrate(). */
template <int dim, bool uniform>
void
integrate(const CellBatch &batch,
          const double *const reference,
          const int n_functions,
          const bool diagonal,
          Lanes *const matrix)
{
  const Gradients<dim, uniform> gradients{batch.gradients};
  const Lanes lambda   = reinterpret_cast<const Lanes *>(batch.moduli)[0];
  const Lanes mu       = reinterpret_cast<const Lanes *>(batch.moduli)[1];
  const auto *pressure = reinterpret_cast<const Lanes *>(batch.pressures);
  const int n          = n_functions * dim;
  for (int i = 0; i < (diagonal ? n : n * n); ++i)
    matrix[i] = Lanes{};
  Lanes g[n_points<dim>][dim], moments[n_points<dim>][dim][dim + 1] = {};

  for (int q = 0; q < n_points<dim>; ++q)
    {
      function_gradients<dim, uniform>(gradients, reference, n_functions, q, g);
      if (pressure != nullptr)
        for (int a = 0; a < n_functions; ++a)
          for (int c = 0; c < dim; ++c)
            for (int k = 0; k <= dim; ++k)
              moments[a][c][k] += pressure[q * (dim + 1) + k] * g[a][c];
      const Lanes direct = pressure != nullptr ? Lanes{} : lambda;
      for (int a = 0; a < n_functions; ++a)
        for (int c = 0; c < dim; ++c)
          if (diagonal)
            matrix[a * dim + c] += direct * g[a][c] * g[a][c] +
                                   mu * distortion<dim>(g[a], g[a], c, c);
          else
            for (int b = 0; b < n_functions; ++b)
              for (int d = 0; d < dim; ++d)
                matrix[(a * dim + c) * n + b * dim + d] +=
                  direct * g[a][c] * g[b][d] +
                  mu * distortion<dim>(g[a], g[b], c, d);
    }
  if (pressure == nullptr)
    return;
  for (int a = 0; a < n_functions; ++a)
    for (int c = 0; c < dim; ++c)
      for (int k = 0; k <= dim; ++k)
        if (diagonal)
          matrix[a * dim + c] += lambda * moments[a][c][k] * moments[a][c][k];
        else
          for (int b = 0; b < n_functions; ++b)
            for (int d = 0; d < dim; ++d)
              matrix[(a * dim + c) * n + b * dim + d] +=
                lambda * moments[a][c][k] * moments[b][d][k];
}
} // namespace
} // namespace SETSUDAN_KIND
} // namespace Setsudan
