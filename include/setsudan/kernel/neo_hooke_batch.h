// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// For batch_kernel.cc alone, like quadratic_grid.h.

#include <setsudan/kernel/displacement_gradients.h>
#include <setsudan/kernel/neo_hooke.h>
#include <setsudan/kernel/tangent_batch.h>

namespace Setsudan
{
namespace SETSUDAN_KIND
{
namespace
{
// The weights of Gauss's rule between 0 and 1.
constexpr double gauss_weight[3] = {5. / 18, 8. / 18, 5. / 18};


inline Lanes
determinant(const Lanes (&a)[2][2])
{
  return a[0][0] * a[1][1] - a[0][1] * a[1][0];
}



inline Lanes
determinant(const Lanes (&a)[3][3])
{
  return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
         a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
         a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}



/** Where a point of the mesh is in the cell. */
template <int dim>
struct PointOnGrid
{
  /** The gradient of the reference coordinates, but for 1/g. */
  Lanes inverse[dim][dim];
  /** Of the point, at rest. */
  Lanes volume;

  PointOnGrid(const Field<dim> &x, const int q)
  {
    Lanes of_x[dim][dim];
    reference_gradient<dim>(x, q, of_x);
    invert(of_x, inverse);
    volume = determinant(of_x);
    for (int d = 0; d < dim; ++d)
      volume = one_over_g * gauss_weight[(q / stride_of[d]) % 3] * volume;
  }
};



/** A neo-Hookean law at a point. */
template <int dim>
struct NeoHookePoint
{
  /** The deformation gradient, and its inverse transposed. */
  Lanes F[dim][dim], G[dim][dim];
  Lanes J;
  NeoHookeTerms<Lanes> terms;

  NeoHookePoint(const CellBatch &batch,
                const NeoHookeForm form,
                const PointOnGrid<dim> &point,
                const Field<dim> &u,
                const int q)
  {
    Lanes of_u[dim][dim], inverse[dim][dim];
    reference_gradient<dim>(u, q, of_u);
    Lanes trace_C = (3. - dim) - Lanes{};
    for (int c = 0; c < dim; ++c)
      for (int d = 0; d < dim; ++d)
        {
          F[c][d] = (c == d ? 1. : 0.) - Lanes{};
          for (int r = 0; r < dim; ++r)
            F[c][d] += of_u[c][r] * point.inverse[r][d];
          trace_C += F[c][d] * F[c][d];
        }
    invert(F, inverse);
    for (int c = 0; c < dim; ++c)
      for (int d = 0; d < dim; ++d)
        G[c][d] = inverse[d][c];
    J           = determinant(F);
    Lanes log_J = J, isochoric = J;
    for (int lane = 0; lane < n_lanes; ++lane)
      {
        log_J[lane] = __builtin_log(J[lane]);
        if (form.is_isochoric)
          isochoric[lane] = __builtin_exp(-2. / 3 * log_J[lane]);
      }
    const auto *const moduli = reinterpret_cast<const Lanes *>(batch.moduli);
    const Lanes lambda = moduli[0], mu = moduli[1];
    terms =
      neo_hooke_terms<Lanes>(form,
                             mu,
                             form.is_isochoric ? lambda + 2. / 3 * mu : lambda,
                             J,
                             log_J,
                             isochoric,
                             trace_C);
  }

  /** C^-1 in the plane, or in space. */
  void
  inverse_C(Lanes (&result)[dim][dim]) const
  {
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        {
          result[i][j] = G[0][i] * G[0][j];
          for (int c = 1; c < dim; ++c)
            result[i][j] += G[c][i] * G[c][j];
        }
  }

  /** The second Piola-Kirchhoff stress. */
  void
  stress(Lanes (&S)[dim][dim]) const
  {
    inverse_C(S);
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        {
          S[i][j] = terms.inverse * S[i][j];
          if (i == j)
            S[i][j] += terms.one;
        }
  }

  /** Add what it gains along the way to another deformation gradient, to first
   * order. */
  void
  extrapolate(const Lanes (&to)[dim][dim], Lanes (&S)[dim][dim]) const
  {
    Lanes E[dim][dim], inverse[dim][dim], E_inverse[dim][dim];
    inverse_C(inverse);
    Lanes trace{}, along{};
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        {
          E[i][j] = Lanes{};
          for (int c = 0; c < dim; ++c)
            E[i][j] += 0.5 * (F[c][i] * (to[c][j] - F[c][j]) +
                              F[c][j] * (to[c][i] - F[c][i]));
          along += inverse[i][j] * E[i][j];
          if (i == j)
            trace += E[i][j];
        }
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        {
          E_inverse[i][j] = Lanes{};
          for (int k = 0; k < dim; ++k)
            E_inverse[i][j] += E[i][k] * inverse[k][j];
        }
    const Lanes of_inverse = terms.cross * trace + terms.square * along;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        {
          S[i][j] += of_inverse * inverse[i][j];
          if (i == j)
            S[i][j] += terms.cross * along;
          for (int k = 0; k < dim; ++k)
            S[i][j] -= 2. * terms.inverse * inverse[i][k] * E_inverse[k][j];
        }
  }
};



/** a^T with the second index in reference coordinates: sum over d of
 * a[c][d] inverse[r][d]. */
template <int dim>
inline void
pull_back(const Lanes (&a)[dim][dim],
          const Lanes (&inverse)[dim][dim],
          Lanes (&result)[dim][dim])
{
  for (int c = 0; c < dim; ++c)
    for (int r = 0; r < dim; ++r)
      {
        result[c][r] = a[c][0] * inverse[r][0];
        for (int d = 1; d < dim; ++d)
          result[c][r] += a[c][d] * inverse[r][d];
      }
}



/** Forces at the points, and the energies of the cells. */
template <int dim>
inline void
neo_hooke_residual(const CellBatch &batch,
                   const NeoHookeForm form,
                   const Field<dim> &x,
                   const Field<dim> &u,
                   Field<dim> &f,
                   double *const energies)
{
  Lanes energy{};
  for (int c = 0; c < dim; ++c)
    for (int q = 0; q < n_points<dim>; ++q)
      f[c][q] = Lanes{};
  for (int q = 0; q < n_points<dim>; ++q)
    {
      const PointOnGrid<dim> at(x, q);
      const NeoHookePoint<dim> point(batch, form, at, u, q);
      energy += at.volume * point.terms.energy;
      for (int lane = 0; lane < n_lanes; ++lane)
        if (!(point.J[lane] > 0))
          energy[lane] = __builtin_inf();
      Lanes P[dim][dim], flux[dim][dim];
      for (int c = 0; c < dim; ++c)
        for (int d = 0; d < dim; ++d)
          P[c][d] = at.volume * (point.terms.one * point.F[c][d] +
                                 point.terms.inverse * point.G[c][d]);
      pull_back<dim>(P, at.inverse, flux);
      for (int r = 0; r < dim; ++r)
        for (int c = 0; c < dim; ++c)
          add_flux<dim>(f, q, r, c, flux[c][r]);
    }
  for (int lane = 0; lane < n_lanes; ++lane)
    energies[lane] = energy[lane];
}



/** The tangent at a point between the gradients in reference coordinates. */
template <int dim>
inline void
point_tangent(const PointOnGrid<dim> &at,
              const NeoHookePoint<dim> &point,
              const Lanes (&stress_change)[dim][dim],
              Lanes *const tangent)
{
  Lanes F[dim][dim], G[dim][dim], beside[dim][dim], direct[dim][dim];
  pull_back<dim>(point.F, at.inverse, F);
  pull_back<dim>(point.G, at.inverse, G);
  // What the same component does: one, and what is extrapolated.
  pull_back<dim>(stress_change, at.inverse, beside);
  for (int r = 0; r < dim; ++r)
    for (int s = 0; s < dim; ++s)
      {
        direct[r][s] = Lanes{};
        for (int d = 0; d < dim; ++d)
          direct[r][s] += at.inverse[r][d] *
                          (point.terms.one * at.inverse[s][d] + beside[d][s]);
      }
  for (int c = 0; c < dim; ++c)
    for (int r = 0; r < dim; ++r)
      for (int e = 0; e <= c; ++e)
        for (int s = 0; s < dim && e * dim + s <= c * dim + r; ++s)
          {
            Lanes sum =
              point.terms.cross * (G[c][r] * F[e][s] + F[c][r] * G[e][s]) +
              point.terms.square * G[c][r] * G[e][s] -
              point.terms.inverse * G[c][s] * G[e][r];
            if (c == e)
              sum += direct[r][s];
            tangent[place_in_tangent<dim>(c * dim + r, e * dim + s)] =
              at.volume * sum;
          }
}



/** @param before nothing where no stress is extrapolated. */
template <int dim>
inline void
neo_hooke_tangent(const CellBatch &batch,
                  const NeoHookeForm form,
                  const Field<dim> &x,
                  const Field<dim> &u,
                  const Field<dim> *const before,
                  double *const tangent)
{
  for (int q = 0; q < n_points<dim>; ++q)
    {
      const PointOnGrid<dim> at(x, q);
      const NeoHookePoint<dim> point(batch, form, at, u, q);
      Lanes change[dim][dim] = {};
      if (before != nullptr)
        {
          const NeoHookePoint<dim> from(batch, form, at, *before, q);
          Lanes S[dim][dim];
          point.stress(S);
          from.stress(change);
          from.extrapolate(point.F, change);
          for (int i = 0; i < dim; ++i)
            for (int j = 0; j < dim; ++j)
              change[i][j] -= S[i][j];
        }
      point_tangent<dim>(at,
                         point,
                         change,
                         reinterpret_cast<Lanes *>(tangent) +
                           q * int(n_in_tangent<dim>));
    }
}
} // namespace
} // namespace SETSUDAN_KIND
} // namespace Setsudan
