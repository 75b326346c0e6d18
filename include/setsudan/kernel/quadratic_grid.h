// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// For batch_kernel.cc alone, which says what SETSUDAN_KIND and SETSUDAN_LANES
// are, and why all of this is in an unnamed namespace.

namespace Setsudan
{
namespace SETSUDAN_KIND
{
namespace
{
constexpr int n_lanes = SETSUDAN_LANES;

/** One number for each cell. A benchmark puts a type in its place that counts
 * what is done to it. */
#ifdef SETSUDAN_LANE_TYPE
using Lanes = SETSUDAN_LANE_TYPE;
#else
typedef double Lanes __attribute__((vector_size(8 * n_lanes), may_alias));
#endif

template <int dim>
constexpr int n_points = dim == 2 ? 9 : 27;

/** The displacement, component by component at the points of a 3^dim grid. */
template <int dim>
using Field = Lanes[dim][n_points<dim>];

constexpr int stride_of[] = {1, 3, 9};

// deal.II's order of the nodes of FE_Q(2), as places in the grid.
template <int dim>
constexpr int place_of_node[n_points<dim>] = {};
template <>
constexpr int place_of_node<2>[9] = {0, 2, 6, 8, 3, 5, 1, 7, 4};
template <>
constexpr int place_of_node<3>[27] = {0,  2,  6,  8,  18, 20, 24, 26, 3,
                                      5,  1,  7,  21, 23, 19, 25, 9,  11,
                                      15, 17, 12, 14, 10, 16, 4,  22, 13};

template <int dim>
constexpr int n_serendipity = dim == 2 ? 8 : 20;


/** In how many directions a place of the grid is in the middle: 0 at corners, 1
 * on edges, 2 on faces, 3 in the middle of a cell in space. */
template <int dim>
constexpr int
n_middles(const int place)
{
  int n = 0;
  for (int d = 0; d < dim; ++d)
    n += (place / stride_of[d]) % 3 == 1;
  return n;
}



/** The strides of the directions in which a place on a face is in the middle.
 */
template <int dim>
constexpr int
first_stride(const int place)
{
  return place % 3 == 1 ? 1 : 3;
}



template <int dim>
constexpr int
second_stride(const int place)
{
  return dim == 3 && (place / 9) % 3 == 1 ? 9 : 3;
}



/** What serendipity functions are at the places where they have no node. */
template <int dim>
inline void
serendipity_to_q2(Lanes (&u)[n_points<dim>])
{
#pragma GCC unroll 27
  for (int place = 0; place < n_points<dim>; ++place)
    if (n_middles<dim>(place) == 2)
      {
        const int a = first_stride<dim>(place), b = second_stride<dim>(place);
        u[place] =
          0.5 * (u[place - a] + u[place + a] + u[place - b] + u[place + b]) -
          0.25 * (u[place - a - b] + u[place + a - b] + u[place - a + b] +
                  u[place + a + b]);
      }
  if constexpr (dim == 3)
    {
      Lanes corners{}, edges{};
#pragma GCC unroll 27
      for (int place = 0; place < n_points<dim>; ++place)
        if (n_middles<dim>(place) == 0)
          corners += u[place];
        else if (n_middles<dim>(place) == 1)
          edges += u[place];
      u[13] = 0.25 * (edges - corners);
    }
}



/** The transpose of serendipity_to_q2(). */
template <int dim>
inline void
q2_to_serendipity_transpose(Lanes (&f)[n_points<dim>])
{
  if constexpr (dim == 3)
    {
      const Lanes quarter = 0.25 * f[13];
#pragma GCC unroll 27
      for (int place = 0; place < n_points<dim>; ++place)
        if (n_middles<dim>(place) == 0)
          f[place] -= quarter;
        else if (n_middles<dim>(place) == 1)
          f[place] += quarter;
    }
#pragma GCC unroll 27
  for (int place = 0; place < n_points<dim>; ++place)
    if (n_middles<dim>(place) == 2)
      {
        const int a = first_stride<dim>(place), b = second_stride<dim>(place);
        const Lanes half = 0.5 * f[place], quarter = 0.25 * f[place];
        f[place - a] += half;
        f[place + a] += half;
        f[place - b] += half;
        f[place + b] += half;
        f[place - a - b] -= quarter;
        f[place + a - b] -= quarter;
        f[place - a + b] -= quarter;
        f[place + a + b] -= quarter;
      }
}



// A quadratic function of values a, b, c at -1, 0, 1 is at the outer Gauss
// points, +-g with g^2 = 3/5, equal to (1 - g^2) b + g^2/2 (a + c) +- g/2 (c -
// a).
constexpr double of_middle = 0.4;
constexpr double of_sum    = 0.3;
constexpr double of_change = 0.38729833462074168852;

/** From the nodes to the Gauss points along one direction. */
template <int dim, int stride>
inline void
to_points(Lanes (&u)[n_points<dim>])
{
#pragma GCC unroll 27
  for (int place = 0; place < n_points<dim>; ++place)
    if ((place / stride) % 3 == 0)
      {
        Lanes &a = u[place], &b = u[place + stride], &c = u[place + 2 * stride];
        const Lanes even = of_middle * b + of_sum * (a + c);
        const Lanes odd  = of_change * (c - a);
        a                = even - odd;
        c                = even + odd;
      }
}



/** The transpose of to_points(). */
template <int dim, int stride>
inline void
to_nodes(Lanes (&f)[n_points<dim>])
{
#pragma GCC unroll 27
  for (int place = 0; place < n_points<dim>; ++place)
    if ((place / stride) % 3 == 0)
      {
        Lanes &a = f[place], &b = f[place + stride], &c = f[place + 2 * stride];
        const Lanes sum = of_sum * (a + c);
        const Lanes odd = of_change * (c - a);
        b += of_middle * (a + c);
        a = sum - odd;
        c = sum + odd;
      }
}



template <int dim>
inline void
to_points(Lanes (&u)[n_points<dim>])
{
  to_points<dim, 1>(u);
  to_points<dim, 3>(u);
  if constexpr (dim == 3)
    to_points<dim, 9>(u);
}



template <int dim>
inline void
to_nodes(Lanes (&f)[n_points<dim>])
{
  to_nodes<dim, 1>(f);
  to_nodes<dim, 3>(f);
  if constexpr (dim == 3)
    to_nodes<dim, 9>(f);
}



// The derivative at the Gauss points -g, 0, g of a quadratic function that is
// known there, in reference coordinates from 0 to 1: each row over g.
constexpr double derivative[3][3] = {{-3, 4, -1}, {-1, 0, 1}, {1, -4, 3}};
constexpr double one_over_g       = 1.29099444873580562839;


/** The displacement's gradient at a point, in reference coordinates and up to
 * the factor 1/g. */
template <int dim>
inline void
reference_gradient(const Field<dim> &u,
                   const int point,
                   Lanes (&gradient)[dim][dim])
{
  for (int r = 0; r < dim; ++r)
    {
      const int stride = stride_of[r];
      const int at     = (point / stride) % 3;
      const int first  = point - at * stride;
      for (int c = 0; c < dim; ++c)
        gradient[c][r] = derivative[at][0] * u[c][first] +
                         derivative[at][1] * u[c][first + stride] +
                         derivative[at][2] * u[c][first + 2 * stride];
    }
}



/** The transpose for one entry of the gradient: add the forces of what is
 * dual to it at a point. */
template <int dim>
inline void
add_flux(Field<dim> &f, const int point, const int r, const int c, Lanes flux)
{
  const int stride = stride_of[r];
  const int at     = (point / stride) % 3;
  const int first  = point - at * stride;
  for (int i = 0; i < 3; ++i)
    if (derivative[at][i] != 0)
      f[c][first + i * stride] += derivative[at][i] * flux;
}
} // namespace
} // namespace SETSUDAN_KIND
} // namespace Setsudan
