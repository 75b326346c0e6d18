// SPDX-License-Identifier: LGPL-2.1-or-later
// How long the mesh surgery takes on a mesh of about a million cells, for cuts
// of different sizes: surgery DIMENSION N_PER_AXIS. A line for each cut: faces
// of the cut, cells that have a vertex on it, vertices made, seconds of the
// surgery and of a copy of the mesh, which is a part of it.

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <setsudan/cut/surface/mesh_surgery.h>
#include <setsudan/cut/surface/surface_choice.h>

#include <algorithm>
#include <iostream>
#include <set>

using namespace Setsudan;

namespace
{
double
seconds_of(const std::function<void()> &action)
{
  // The best of three, since other programs only ever add time.
  double best = 1e300;
  for (unsigned int repeat = 0; repeat < 3; ++repeat)
    {
      dealii::Timer timer;
      action();
      best = std::min(best, timer.wall_time());
    }
  return best;
}

template <int dim>
void
measure(const unsigned int n)
{
  dealii::Point<dim> size;
  typename BoxNumbering<dim>::Indices n_elements;
  n_elements.fill(n);
  for (unsigned int d = 0; d < dim; ++d)
    size[d] = 1;
  const auto body  = make_box<dim>(size, n_elements);
  const auto whole = LayerBoundary<dim>(0, n / 2).choose(body).faces;

  for (const double part : {1., 0.3, 0.1, 0.03, 0.01})
    {
      CutSurface<dim> surface;
      std::set<unsigned int> vertices;
      for (const auto &face : whole)
        if (body.mesh.cell_center(face.minus.first)[dim - 1] > 1 - part)
          {
            surface.push_back(face);
            for (const unsigned int v : body.mesh.face_key(face.minus))
              vertices.insert(v);
          }
      unsigned int n_touched = 0;
      for (const auto &cell : body.mesh.cells)
        n_touched += std::any_of(
          cell.vertices.begin(),
          cell.vertices.end(),
          [&](const unsigned int v) { return vertices.count(v) > 0; });
      CoarseMesh<dim> split;
      const double surgery =
        seconds_of([&]() { split = split_mesh(body.mesh, surface); });
      const double copy = seconds_of([&]() { split = body.mesh; });
      split             = split_mesh(body.mesh, surface);
      std::cout << surface.size() << ' ' << n_touched << ' '
                << split.vertices.size() - body.mesh.vertices.size() << ' '
                << surgery << ' ' << copy << std::endl;
    }
}
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (argc != 3)
    {
      std::cerr << "usage: surgery DIMENSION N_PER_AXIS" << std::endl;
      return 2;
    }
  if (std::stoi(argv[1]) == 2)
    measure<2>(std::stoi(argv[2]));
  else
    measure<3>(std::stoi(argv[2]));
}
