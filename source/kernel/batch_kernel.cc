// Compiled once for each kind of processor: SETSUDAN_KIND is its name, and
// SETSUDAN_LANES the numbers that its vector registers hold. It must not
// include what has inline functions: the linker would take those of one kind
// for all.
#include <setsudan/kernel/stiffness_kernel.h>

#define SETSUDAN_STRING_(name) #name
#define SETSUDAN_STRING(name) SETSUDAN_STRING_(name)

namespace Setsudan
{
namespace SETSUDAN_KIND
{
namespace
{
constexpr int n_lanes = SETSUDAN_LANES;

/** One number for each cell. */
typedef double Lanes __attribute__((vector_size(8 * n_lanes), may_alias));

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
expand(Lanes (&u)[n_points<dim>])
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



/** The transpose of expand(). */
template <int dim>
inline void
contract(Lanes (&f)[n_points<dim>])
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
resist(const CellBatch &batch, const Field<dim> &u, Field<dim> &f)
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
        {
          const int stride = stride_of[r];
          const int at     = (q / stride) % 3;
          const int first  = q - at * stride;
          for (int c = 0; c < dim; ++c)
            {
              Lanes flux = stress[c][0] * s[r][0];
              for (int d = 1; d < dim; ++d)
                flux += stress[c][d] * s[r][d];
              for (int i = 0; i < 3; ++i)
                if (derivative[at][i] != 0)
                  f[c][first + i * stride] += derivative[at][i] * flux;
            }
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



template <int dim, bool serendipity>
void
apply(const CellBatch &batch,
      const double *const displacement,
      double *const forces)
{
  constexpr int n_nodes = serendipity ? n_serendipity<dim> : n_points<dim>;
  Field<dim> u, f;
  read<dim>(batch, n_nodes, displacement, u);
  for (int c = 0; c < dim; ++c)
    {
      if constexpr (serendipity)
        expand<dim>(u[c]);
      to_points<dim>(u[c]);
    }
  if (batch.pressures != nullptr)
    batch.is_uniform ? resist<dim, true, true>(batch, u, f)
                     : resist<dim, false, true>(batch, u, f);
  else
    batch.is_uniform ? resist<dim, true, false>(batch, u, f)
                     : resist<dim, false, false>(batch, u, f);
  for (int c = 0; c < dim; ++c)
    {
      to_nodes<dim>(f[c]);
      if constexpr (serendipity)
        contract<dim>(f[c]);
    }
  add<dim>(batch, n_nodes, f, forces);
}


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



template <int dim>
void
integrate(const CellBatch &batch,
          const double *const gradients,
          const unsigned int n_functions,
          const bool diagonal,
          double *const matrix)
{
  const auto of_shape =
    batch.is_uniform ? integrate<dim, true> : integrate<dim, false>;
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
                                           integrate<dim>};
  return kernel;
}



template const StiffnessKernel<2> &
kernel();
template const StiffnessKernel<3> &
kernel();
} // namespace SETSUDAN_KIND
} // namespace Setsudan
