// SPDX-License-Identifier: LGPL-2.1-or-later
// How fast K u is computed without a matrix, beside what the processor could:
// throughput N for N^3 elements. Prints names and values in a
// line: unknowns; for general cells and for cells of one shape the products'
// unknowns per second, floating point operations and bytes per cell; and for
// one core of this machine operations per second (dgemm) and bytes per second
// (a scaled sum of two arrays).

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <setsudan/kernel/blas.h>
#include <setsudan/mechanics/cell_batches.h>

#include <Teuchos_BLAS.hpp>

#include <algorithm>
#include <iostream>

#include "../../tests/mechanics/small_model.h"
#include "counted_kernel.h"

using namespace Setsudan;
using namespace dealii;

namespace
{
constexpr int dim = 3;

/** The shortest time that something takes, in some tries of a tenth of a second
 * or more. */
template <typename Work>
double
shortest_time(const Work &work)
{
  double shortest = 1e300;
  work();
  for (unsigned int attempt = 0; attempt < 5; ++attempt)
    {
      Timer timer;
      unsigned int n = 0;
      do
        {
          work();
          ++n;
        }
      while (timer.wall_time() < 0.1);
      shortest = std::min(shortest, timer.wall_time() / n);
    }
  return shortest;
}


double
flops_of_core()
{
  const SingleThreadedBlas one_core;
  const int n = 1200;
  std::vector<double> a(n * n, 1.), b(n * n, 1.), c(n * n);
  const Teuchos::BLAS<int, double> blas;
  return 2. * n * n * n / shortest_time([&] {
           blas.GEMM(Teuchos::NO_TRANS,
                     Teuchos::NO_TRANS,
                     n,
                     n,
                     n,
                     1.,
                     a.data(),
                     n,
                     b.data(),
                     n,
                     0.,
                     c.data(),
                     n);
         });
}


double
bandwidth_of_core()
{
  // Far beyond all caches.
  const std::size_t n = 1 << 25;
  std::vector<double> a(n, 1.), b(n, 2.), c(n, 3.);
  // a is read before it is written.
  return 32. * n / shortest_time([&] {
           for (std::size_t i = 0; i < n; ++i)
             a[i] = b[i] + 3. * c[i];
         });
}


/** Bytes that the product moves for each cell, where what is shared by
 * neighbours is moved once. */
double
bytes_per_cell(const CellBatches<dim> &batches, const double n_unknowns)
{
  const double n_cells = batches.cells().size();
  // u is read, f is read and written.
  double bytes = 3 * 8 * n_unknowns / n_cells;
  bytes += batches.n_nodes() * sizeof(unsigned int) + 2 * sizeof(double);
  if (!batches[0].is_uniform)
    bytes += 27 * dim * dim * sizeof(double);
  return bytes;
}


void
measure(const std::string &name, const CoarseMesh<dim> &mesh)
{
  SmallModel<dim> small({"Body/Elements=1,1,1"}, &mesh);
  const auto &batches = small.model.batches();
  auto u = batches.copy_in(small.model.discretization.zero_vector());
  for (unsigned int i = 0; i < u.locally_owned_size(); ++i)
    u.local_element(i) = i % 7;
  auto f                  = u;
  const double n_unknowns = u.locally_owned_size();
  const double seconds    = shortest_time([&] { batches.apply(u, f); });
  std::cout << "unknowns " << n_unknowns << " " << name << "_rate "
            << n_unknowns / seconds << " " << name << "_flops "
            << counted_operations(batches[0]) << " " << name << "_bytes "
            << bytes_per_cell(batches, n_unknowns) << " " << name << "_cells "
            << batches.cells().size() / seconds << " ";
}
} // namespace


int
main(int argc, char **argv)
{
  start_with_fitting_blas(argv);
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (argc != 2)
    {
      std::cerr << "usage: throughput N\n";
      return 1;
    }
  const std::string n(argv[1]);
  const auto box =
    SmallBody<dim>({"Body/Elements=" + n + "," + n + "," + n}).body.mesh;
  measure("uniform", box);
  measure("general", distorted(box));
  std::cout << "core_flops " << flops_of_core() << " core_bytes "
            << bandwidth_of_core() << std::endl;
}
