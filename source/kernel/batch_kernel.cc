// SPDX-License-Identifier: LGPL-2.1-or-later
// Compiled once for each kind of processor: SETSUDAN_KIND is its name, and
// SETSUDAN_LANES the numbers that its vector registers hold. It must not
// include what has inline functions with a name outside this file: the linker
// would take those of one kind for all.
#include <setsudan/kernel/displacement_gradients.h>
#include <setsudan/kernel/function_stiffness.h>
#include <setsudan/kernel/neo_hooke_batch.h>
#include <setsudan/kernel/quadratic_grid.h>
#include <setsudan/kernel/stiffness_kernel.h>
#include <setsudan/kernel/tangent_batch.h>

#define SETSUDAN_STRING_(name) #name
#define SETSUDAN_STRING(name) SETSUDAN_STRING_(name)

namespace Setsudan
{
namespace SETSUDAN_KIND
{
namespace
{
/** Have numbers brought into the second cache. */
inline void
fetch(const double *const numbers, const int n)
{
  constexpr int n_in_line = 8;
  for (int i = 0; i < n; i += n_in_line)
    __builtin_prefetch(numbers + i, 0, 1);
}



/** The divergence at all points, times the root of weight and volume. */
template <int dim, bool uniform>
inline void
divergences(const Field<dim> &u,
            const Gradients<dim, uniform> gradients,
            Lanes (&divergence)[n_points<dim>])
{
  for (int q = 0; q < n_points<dim>; ++q)
    {
      Lanes reference[dim][dim];
      reference_gradient<dim>(u, q, reference);
      Lanes sum{};
      for (int c = 0; c < dim; ++c)
        for (int r = 0; r < dim; ++r)
          sum += reference[c][r] * gradients(q, r, c);
      divergence[q] = one_over_g * sum;
    }
}



/** Project what is known at all points. */
template <int dim>
inline void
project(const Lanes *const basis, Lanes (&values)[n_points<dim>])
{
  Lanes moments[dim + 1] = {};
  for (int q = 0; q < n_points<dim>; ++q)
    for (int k = 0; k <= dim; ++k)
      moments[k] += basis[q * (dim + 1) + k] * values[q];
  for (int q = 0; q < n_points<dim>; ++q)
    {
      values[q] = Lanes{};
      for (int k = 0; k <= dim; ++k)
        values[q] += basis[q * (dim + 1) + k] * moments[k];
    }
}



/** From the displacement at the points to the forces there. */
template <int dim, bool uniform, bool mixed>
inline void
cell_residual(const CellBatch &batch, const Field<dim> &u, Field<dim> &f)
{
  const Gradients<dim, uniform> gradients{batch.gradients};
  const Lanes lambda = reinterpret_cast<const Lanes *>(batch.moduli)[0];
  const Lanes mu     = reinterpret_cast<const Lanes *>(batch.moduli)[1];
  Lanes dilatation[n_points<dim>];
  if constexpr (mixed)
    {
      divergences<dim, uniform>(u, gradients, dilatation);
      project<dim>(reinterpret_cast<const Lanes *>(batch.pressures),
                   dilatation);
    }
  for (int c = 0; c < dim; ++c)
    for (int q = 0; q < n_points<dim>; ++q)
      f[c][q] = Lanes{};

#pragma GCC unroll 3
  for (int q = 0; q < n_points<dim>; ++q)
    {
      if (batch.next_gradients != nullptr)
        fetch(batch.next_gradients + q * dim * dim * n_lanes,
              dim * dim * n_lanes);
      Lanes reference[dim][dim], s[dim][dim], gradient[dim][dim] = {};
      reference_gradient<dim>(u, q, reference);
      for (int r = 0; r < dim; ++r)
        for (int d = 0; d < dim; ++d)
          s[r][d] = one_over_g * gradients(q, r, d);
      for (int c = 0; c < dim; ++c)
        for (int d = 0; d < dim; ++d)
          for (int r = 0; r < dim; ++r)
            gradient[c][d] += reference[c][r] * s[r][d];

      Lanes trace = gradient[0][0];
      for (int c = 1; c < dim; ++c)
        trace += gradient[c][c];
      if constexpr (mixed)
        trace = dilatation[q];
      Lanes stress[dim][dim];
      for (int c = 0; c < dim; ++c)
        {
          stress[c][c] = 2. * mu * gradient[c][c] + lambda * trace;
          for (int d = 0; d < c; ++d)
            stress[c][d] = stress[d][c] =
              mu * (gradient[c][d] + gradient[d][c]);
        }

      for (int r = 0; r < dim; ++r)
        for (int c = 0; c < dim; ++c)
          {
            Lanes flux = stress[c][0] * s[r][0];
            for (int d = 1; d < dim; ++d)
              flux += stress[c][d] * s[r][d];
            add_flux<dim>(f, q, r, c, flux);
          }
    }
}



template <int dim>
inline void
read(const CellBatch &batch,
     const int n_nodes,
     const double *const vector,
     Field<dim> &u)
{
  for (int node = 0; node < n_nodes; ++node)
    for (int lane = 0; lane < n_lanes; ++lane)
      {
        const double *const at = vector + batch.nodes[node * n_lanes + lane];
        for (int c = 0; c < dim; ++c)
          u[c][place_of_node<dim>[node]][lane] = at[c];
      }
}



/** A field on the grid of a cell's nodes. */
template <int dim, bool serendipity>
inline void
read_on_grid(const CellBatch &batch,
             const double *const vector,
             Field<dim> &field)
{
  read<dim>(
    batch, serendipity ? n_serendipity<dim> : n_points<dim>, vector, field);
  if constexpr (serendipity)
    for (int c = 0; c < dim; ++c)
      serendipity_to_q2<dim>(field[c]);
}



template <int dim>
inline void
add(const CellBatch &batch,
    const int n_nodes,
    const Field<dim> &f,
    double *const vector)
{
  for (int node = 0; node < n_nodes; ++node)
    for (unsigned int lane = 0; lane < batch.n_cells; ++lane)
      {
        double *const at = vector + batch.nodes[node * n_lanes + lane];
        for (int c = 0; c < dim; ++c)
          at[c] += f[c][place_of_node<dim>[node]][lane];
      }
}



/** A field at Gauss's points. */
template <int dim, bool serendipity>
inline void
read_at_points(const CellBatch &batch,
               const double *const vector,
               Field<dim> &field)
{
  read_on_grid<dim, serendipity>(batch, vector, field);
  for (int c = 0; c < dim; ++c)
    to_points<dim>(field[c]);
}



/** Add the forces of a field of forces at Gauss's points. */
template <int dim, bool serendipity>
inline void
add_from_points(const CellBatch &batch, Field<dim> &f, double *const forces)
{
  constexpr int n_nodes = serendipity ? n_serendipity<dim> : n_points<dim>;
  for (int c = 0; c < dim; ++c)
    {
      to_nodes<dim>(f[c]);
      if constexpr (serendipity)
        q2_to_serendipity_transpose<dim>(f[c]);
    }
  add<dim>(batch, n_nodes, f, forces);
}



template <int dim, bool serendipity>
void
apply(const CellBatch &batch,
      const double *const displacement,
      double *const forces)
{
  Field<dim> u, f;
  read_at_points<dim, serendipity>(batch, displacement, u);
  if (batch.tangent != nullptr)
    tangent_residual<dim>(batch, u, f);
  else if (batch.pressures != nullptr)
    batch.is_uniform ? cell_residual<dim, true, true>(batch, u, f)
                     : cell_residual<dim, false, true>(batch, u, f);
  else
    batch.is_uniform ? cell_residual<dim, true, false>(batch, u, f)
                     : cell_residual<dim, false, false>(batch, u, f);
  add_from_points<dim, serendipity>(batch, f, forces);
}



template <int dim, bool serendipity>
void
neo_hooke(const CellBatch &batch,
          const NeoHookeState &state,
          double *const forces,
          double *const energies)
{
  Field<dim> x, u, f;
  read_at_points<dim, serendipity>(batch, state.positions, x);
  read_at_points<dim, serendipity>(batch, state.displacement, u);
  neo_hooke_residual<dim>(batch, state.form, x, u, f, energies);
  add_from_points<dim, serendipity>(batch, f, forces);
}



template <int dim, bool serendipity>
void
tangent(const CellBatch &batch,
        const NeoHookeState &state,
        const double *const before,
        double *const result)
{
  Field<dim> x, u, from;
  read_at_points<dim, serendipity>(batch, state.positions, x);
  read_at_points<dim, serendipity>(batch, state.displacement, u);
  if (before != nullptr)
    read_at_points<dim, serendipity>(batch, before, from);
  neo_hooke_tangent<dim>(
    batch, state.form, x, u, before != nullptr ? &from : nullptr, result);
}



template <int dim, bool serendipity>
void
displacement_gradients(const CellBatch &batch,
                       const double *const positions,
                       const double *const displacement,
                       double *const gradients)
{
  using Gradient = Lanes[dim][dim];
  auto *const at = reinterpret_cast<Gradient *>(gradients);
  Field<dim> x, u;
  read_on_grid<dim, serendipity>(batch, positions, x);
  read_on_grid<dim, serendipity>(batch, displacement, u);
  gradients_on_grid<dim>(x, u, at);
  for (int c = 0; c < dim; ++c)
    {
      to_points<dim>(x[c]);
      to_points<dim>(u[c]);
    }
  gradients_on_grid<dim>(x, u, at + n_points<dim>);
}


template <int dim>
void
integrate(const CellBatch &batch,
          const double *const gradients,
          const unsigned int n_functions,
          const bool diagonal,
          double *const matrix)
{
  const auto of_shape = batch.tangent != nullptr ? integrate_tangent<dim>
                        : batch.is_uniform       ? integrate<dim, true>
                                                 : integrate<dim, false>;
  of_shape(
    batch, gradients, n_functions, diagonal, reinterpret_cast<Lanes *>(matrix));
}
} // namespace


template <int dim>
const StiffnessKernel<dim> &
kernel();
template <int dim>
const StiffnessKernel<dim> &
kernel()
{
  static const StiffnessKernel<dim> kernel{SETSUDAN_STRING(SETSUDAN_KIND),
                                           n_lanes,
                                           apply<dim, true>,
                                           apply<dim, false>,
                                           displacement_gradients<dim, true>,
                                           displacement_gradients<dim, false>,
                                           integrate<dim>,
                                           neo_hooke<dim, true>,
                                           neo_hooke<dim, false>,
                                           tangent<dim, true>,
                                           tangent<dim, false>};
  return kernel;
}



template const StiffnessKernel<2> &
kernel();
template const StiffnessKernel<3> &
kernel();
} // namespace SETSUDAN_KIND
} // namespace Setsudan
