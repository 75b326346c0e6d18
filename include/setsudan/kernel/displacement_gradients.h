// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// For batch_kernel.cc alone, like quadratic_grid.h.

#include <setsudan/kernel/quadratic_grid.h>

namespace Setsudan
{
namespace SETSUDAN_KIND
{
namespace
{
/** The inverse of a matrix. */
inline void
invert(const Lanes (&a)[2][2], Lanes (&inverse)[2][2])
{
  const Lanes over = 1. / (a[0][0] * a[1][1] - a[0][1] * a[1][0]);
  inverse[0][0]    = over * a[1][1];
  inverse[0][1]    = -over * a[0][1];
  inverse[1][0]    = -over * a[1][0];
  inverse[1][1]    = over * a[0][0];
}



inline void
invert(const Lanes (&a)[3][3], Lanes (&inverse)[3][3])
{
  const auto cofactor = [&](const int i, const int j) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    return a[i1][j1] * a[i2][j2] - a[i1][j2] * a[i2][j1];
  };
  const Lanes over = 1. / (a[0][0] * cofactor(0, 0) + a[0][1] * cofactor(0, 1) +
                           a[0][2] * cofactor(0, 2));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      inverse[j][i] = over * cofactor(i, j);
}



/** The displacement's gradient at all points of the grid on which the positions
 * x and the displacement u are known, both up to the same factor. */
template <int dim>
inline void
gradients_on_grid(const Field<dim> &x,
                  const Field<dim> &u,
                  Lanes (*const gradients)[dim][dim])
{
  for (int q = 0; q < n_points<dim>; ++q)
    {
      Lanes of_x[dim][dim], of_u[dim][dim], inverse[dim][dim];
      reference_gradient<dim>(x, q, of_x);
      reference_gradient<dim>(u, q, of_u);
      invert(of_x, inverse);
      for (int c = 0; c < dim; ++c)
        for (int d = 0; d < dim; ++d)
          {
            gradients[q][c][d] = Lanes{};
            for (int r = 0; r < dim; ++r)
              gradients[q][c][d] += of_u[c][r] * inverse[r][d];
          }
    }
}
} // namespace
} // namespace SETSUDAN_KIND
} // namespace Setsudan
