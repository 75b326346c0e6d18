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
/** Where an entry of a symmetric matrix is, of which one half is kept. */
template <int dim>
constexpr int
place_in_tangent(const int i, const int j)
{
  return i < j ? j * (j + 1) / 2 + i : i * (i + 1) / 2 + j;
}


template <int dim>
inline const Lanes *
tangent_at(const CellBatch &batch, const int q)
{
  return reinterpret_cast<const Lanes *>(batch.tangent) +
         q * int(n_in_tangent<dim>);
}



/** From the displacement at the points to the forces of the tangent there. */
template <int dim>
inline void
tangent_residual(const CellBatch &batch, const Field<dim> &u, Field<dim> &f)
{
  for (int c = 0; c < dim; ++c)
    for (int q = 0; q < n_points<dim>; ++q)
      f[c][q] = Lanes{};
#pragma GCC unroll 3
  for (int q = 0; q < n_points<dim>; ++q)
    {
      Lanes gradient[dim][dim], flux[dim * dim] = {};
      reference_gradient<dim>(u, q, gradient);
      const Lanes *entries = tangent_at<dim>(batch, q);
      // Each entry but those of the diagonal counts twice.
      for (int i = 0; i < dim * dim; ++i)
        for (int j = 0; j <= i; ++j)
          {
            const Lanes entry = *entries++;
            flux[i] += entry * gradient[j / dim][j % dim];
            if (j < i)
              flux[j] += entry * gradient[i / dim][i % dim];
          }
      for (int r = 0; r < dim; ++r)
        for (int c = 0; c < dim; ++c)
          add_flux<dim>(f, q, r, c, flux[c * dim + r]);
    }
}



/** The tangent times a function's gradient, for each of its components, at all
 * points: [point][entry of the gradient][component]. */
template <int dim>
inline void
tangent_of_function(const CellBatch &batch,
                    const double *const reference,
                    const int n_functions,
                    const int function,
                    Lanes (*const result)[dim * dim][dim])
{
  for (int q = 0; q < n_points<dim>; ++q)
    {
      const Lanes *const tangent = tangent_at<dim>(batch, q);
      const double *const g = reference + (q * n_functions + function) * dim;
      for (int i = 0; i < dim * dim; ++i)
        for (int c = 0; c < dim; ++c)
          {
            Lanes sum{};
            for (int s = 0; s < dim; ++s)
              sum += g[s] / one_over_g *
                     tangent[place_in_tangent<dim>(i, c * dim + s)];
            result[q][i][c] = 1 / one_over_g * sum;
          }
    }
}



/** See StiffnessKernel::integrate(). */
template <int dim>
void
integrate_tangent(const CellBatch &batch,
                  const double *const reference,
                  const int n_functions,
                  const bool diagonal,
                  Lanes *const matrix)
{
  const int n = n_functions * dim;
  Lanes of_function[n_points<dim>][dim * dim][dim];
  for (int b = 0; b < n_functions; ++b)
    {
      tangent_of_function<dim>(batch, reference, n_functions, b, of_function);
      for (int a = diagonal ? b : 0; a <= b; ++a)
        {
          Lanes block[dim][dim] = {};
          for (int q = 0; q < n_points<dim>; ++q)
            {
              const double *const g = reference + (q * n_functions + a) * dim;
              for (int c = 0; c < dim; ++c)
                for (int d = 0; d < dim; ++d)
                  for (int r = 0; r < dim; ++r)
                    block[c][d] += g[r] * of_function[q][c * dim + r][d];
            }
          for (int c = 0; c < dim; ++c)
            for (int d = 0; d < dim; ++d)
              if (!diagonal)
                matrix[(a * dim + c) * n + b * dim + d] =
                  matrix[(b * dim + d) * n + a * dim + c] = block[c][d];
              else if (c == d)
                matrix[a * dim + c] = block[c][c];
        }
    }
}
} // namespace
} // namespace SETSUDAN_KIND
} // namespace Setsudan
