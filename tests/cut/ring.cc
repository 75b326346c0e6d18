// SPDX-License-Identifier: LGPL-2.1-or-later
// A ring that is cut once stays in one piece, which is open; cut twice it
// falls into two. With straight lines, and with round ones, whose middle nodes
// go with the elements.

#include <setsudan/cut/seam/sides.h>
#include <setsudan/cut/surface/mesh_surgery.h>
#include <setsudan/cut/surface/surface_choice.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "../parameters/check.h"
#include "../test_setup.h"
#include "topology.h"

using namespace Setsudan;
using namespace dealii;

// Elements around, from the inner to the outer radius, and along the axis.
constexpr unsigned int n_around = 8, n_across = 2, n_along = 3;
constexpr double inner = 1, outer = 2, length = 1.5;


/** The point at half-indices along the radius, around, and along the axis. */
template <int dim>
Point<dim>
point_of_ring(const unsigned int i, const unsigned int j, const unsigned int k)
{
  const double radius = inner + (outer - inner) * i / (2. * n_across);
  const double angle  = numbers::PI * j / n_around;
  Point<dim> point;
  point[0] = radius * std::cos(angle);
  point[1] = radius * std::sin(angle);
  if (dim == 3)
    point[dim - 1] = length * k / (2. * n_along);
  return point;
}


template <int dim>
Body<dim>
make_ring(const bool is_round)
{
  Body<dim> body;
  CoarseMesh<dim> &mesh         = body.mesh;
  const unsigned int last_layer = dim == 3 ? n_along : 0;
  for (unsigned int k = 0; k <= last_layer; ++k)
    for (unsigned int j = 0; j < n_around; ++j)
      for (unsigned int i = 0; i <= n_across; ++i)
        mesh.vertices.push_back(point_of_ring<dim>(2 * i, 2 * j, 2 * k));
  for (unsigned int k = 0; k < std::max(last_layer, 1u); ++k)
    for (unsigned int j = 0; j < n_around; ++j)
      for (unsigned int i = 0; i < n_across; ++i)
        {
          mesh.cells.emplace_back();
          typename CoarseMesh<dim>::LineNodes line_nodes;
          for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
            {
              const auto at   = unit_point_of_node<dim>(node);
              const double up = dim == 3 ? at[dim - 1] : 0;
              if (node < GeometryInfo<dim>::vertices_per_cell)
                mesh.cells.back().vertices[node] =
                  ((k + up) * n_around + (j + int(at[1])) % n_around) *
                    (n_across + 1) +
                  i + at[0];
              else
                line_nodes[node - GeometryInfo<dim>::vertices_per_cell] =
                  point_of_ring<dim>(
                    2 * (i + at[0]), 2 * (j + at[1]), 2 * (k + up));
            }
          if (is_round)
            mesh.line_nodes.push_back(line_nodes);
        }
  return body;
}


/** The area between regular polygons; where they are round, with segments of
 * parabolas, which have two thirds of their chords and heights. */
double
area_of_ring(const bool is_round)
{
  const double half = numbers::PI / n_around;
  double polygon    = std::sin(half) * std::cos(half);
  if (is_round)
    polygon += 2. / 3 * 2 * std::sin(half) * (1 - std::cos(half));
  return n_around * polygon * (outer * outer - inner * inner);
}


/** Cut where y = 0 and `is_there`; the pieces must have this volume each. */
template <int dim>
void
cut(const std::string &name,
    const Body<dim> &body,
    const std::function<bool(const Point<dim> &)> &is_there,
    const double volume)
{
  const ChosenSurface<dim> chosen =
    LevelSet<dim>([](const Point<dim> &p) { return p[1]; }).choose(body);
  CutSurface<dim> surface;
  for (const auto &face : chosen.faces)
    if (is_there(body.mesh.cell_center(face.minus.first)))
      surface.push_back(face);
  const auto area   = measure_surface(body, surface);
  const auto mesh   = split_mesh(body.mesh, surface);
  const auto pieces = find_pieces(mesh);
  std::cout << dim << "D, " << name << ": " << surface.size() << " faces"
            << std::endl;
  double error = chosen.roughness;
  for (auto piece : topology_of_pieces(mesh, pieces))
    {
      error        = std::max(error, std::abs(piece.volume - volume));
      piece.volume = volume;
      std::cout << "  " << piece << std::endl;
    }
  // Every section has the normal of y.
  const double section = (outer - inner) * (dim == 3 ? length : 1.);
  const double sections =
    surface.size() / (n_across * (dim == 3 ? n_along : 1.));
  error = std::max(error, std::abs(area.area - sections * section));
  error = std::max(
    error, (area.vector - area.area * Point<dim>::unit_vector(1)).norm());
  check_below("  volumes, roughness and areas", error, 1e-13);

  // The nearest face is seen from the half that an element is in.
  bool sides_fit   = true;
  const auto sides = find_sides(mesh, surface);
  for (unsigned int cell = 0; cell < sides.size(); ++cell)
    sides_fit =
      sides_fit && sides[cell] == (surface.empty()                      ? 0
                                   : body.mesh.cell_center(cell)[1] > 0 ? 1
                                                                        : -1);
  check("  sides", sides_fit);
}


template <int dim>
void
test(const bool is_round)
{
  std::cout << (is_round ? "round" : "straight") << std::endl;
  using P              = Point<dim>;
  const Body<dim> ring = make_ring<dim>(is_round);
  const double volume  = area_of_ring(is_round) * (dim == 3 ? length : 1.);
  cut<dim>(
    "whole", ring, [](const P &) { return false; }, volume);
  cut<dim>(
    "cut once", ring, [](const P &p) { return p[0] > 0; }, volume);
  cut<dim>(
    "cut twice", ring, [](const P &) { return true; }, volume / 2);
  // A slit from the inside does not open it.
  cut<dim>(
    "slit", ring, [](const P &p) { return p[0] > 0 && p[0] < 1.3; }, volume);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for (const bool is_round : {false, true})
      {
        test<2>(is_round);
        test<3>(is_round);
      }
  });
}
