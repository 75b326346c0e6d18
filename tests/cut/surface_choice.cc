// SPDX-License-Identifier: LGPL-2.1-or-later
// The surfaces that a cut can follow: which faces they are, which side is plus,
// how well they fit, and what is none.

#include <setsudan/cut/surface/surface_choice.h>
#include <setsudan/mesh/face_index.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "../parameters/check.h"
#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

/** A box of cubes of edge 1; in 2D without the last number. */
template <int dim>
Body<dim>
cubes(const std::array<unsigned int, 3> &n)
{
  Point<dim> size;
  typename BoxNumbering<dim>::Indices n_elements;
  for (unsigned int d = 0; d < dim; ++d)
    size[d] = n_elements[d] = n[d];
  return make_box<dim>(size, n_elements);
}


/** All interior faces, minus first, whose cells a function names -1 and +1. */
template <int dim>
std::set<std::pair<CellFace, CellFace>>
faces_between(const Body<dim> &body,
              const std::function<int(const Point<dim> &)> &side)
{
  std::set<std::pair<CellFace, CellFace>> faces;
  const auto neighbors = collect_neighbors(body.mesh);
  const FaceIndex<dim> index(body.mesh);
  for (unsigned int cell = 0; cell < neighbors.size(); ++cell)
    for (unsigned int face = 0; face < neighbors[cell].size(); ++face)
      if (const unsigned int other = neighbors[cell][face];
          other != numbers::invalid_unsigned_int &&
          side(body.mesh.cell_center(cell)) == -1 &&
          side(body.mesh.cell_center(other)) == 1)
        {
          const auto both = index.find(body.mesh.face_key({cell, face}));
          faces.insert(
            {{cell, face}, both[0].first == cell ? both[1] : both[0]});
        }
  return faces;
}


template <int dim>
void
compare(const std::string &name,
        const Body<dim> &body,
        const SurfaceChoice<dim> &choice,
        const double roughness,
        const std::function<int(const Point<dim> &)> &side)
{
  const auto surface = choice.choose(body);
  std::set<std::pair<CellFace, CellFace>> faces;
  for (const auto &face : surface.faces)
    faces.insert({face.minus, face.plus});
  const auto area = measure_surface(body, surface.faces);
  std::cout << dim << "D, " << name << ": " << surface.faces.size()
            << " faces, area " << area.area << ", in all (";
  for (unsigned int d = 0; d < dim; ++d)
    std::cout << (d == 0 ? "" : " ")
              << (std::abs(area.vector[d]) < 1e-12 ? 0. : area.vector[d]);
  std::cout << "), " << find_branchings(body, surface.faces).size()
            << " branchings" << std::endl;
  check("  the faces that it should be",
        faces == faces_between(body, side) &&
          faces.size() == surface.faces.size());
  check_below("  roughness", std::abs(surface.roughness - roughness), 1e-6);
}


template <int dim>
void
test_planes()
{
  const auto body  = cubes<dim>({{4, 4, 2}});
  using P          = Point<dim>;
  const auto sides = [](const auto &function) {
    return [function](const P &p) { return function(p) < 0 ? -1 : 1; };
  };
  const auto half = [](const P &p) { return p[1] - 2; };
  compare<dim>(
    "layer boundary", body, LayerBoundary<dim>(1, 2), 0, sides(half));
  compare<dim>("plane", body, LevelSet<dim>(half), 0, sides(half));
  // Through centers, which then are on the plus side, off them, and turned.
  const auto centers = [](const P &p) { return p[1] - 1.5; };
  compare<dim>(
    "plane between", body, LevelSet<dim>(centers), 0.5, sides(centers));
  const auto off = [](const P &p) { return 1.8 - p[0]; };
  compare<dim>(
    "plane from the right", body, LevelSet<dim>(off), 0.2, sides(off));
  const auto diagonal = [](const P &p) { return 1e6 * (p[0] + p[1] - 4); };
  compare<dim>("diagonal plane",
               body,
               LevelSet<dim>(diagonal),
               std::sqrt(0.5),
               sides(diagonal));
  const auto outside = [](const P &p) { return p[0] - 7; };
  compare<dim>(
    "plane outside", body, LevelSet<dim>(outside), 0, sides(outside));
}


/** Around what is in the middle of 3 x 3 (x 3) cubes; and around two of them,
 * which meet at a line, or in 2D at a vertex. */
template <int dim>
void
test_closed()
{
  const auto body = cubes<dim>({{3, 3, 3}});
  using P         = Point<dim>;
  P middle;
  for (unsigned int d = 0; d < dim; ++d)
    middle[d] = 1.5;
  const auto ball = [=](const P &p) { return p.distance(middle) - 0.5; };
  const auto side = [=](const P &p) { return ball(p) < 0 ? -1 : 1; };
  compare<dim>(
    "ball", body, LevelSet<dim>(ball), (std::sqrt(dim) - 1) / 2, side);

  std::vector<EntityKey> keys;
  for (const auto &face : LevelSet<dim>(ball).choose(body).faces)
    keys.push_back(body.mesh.face_key(face.minus));
  compare<dim>("group around it", body, GroupOfFaces<dim>(keys), 0, side);

  const auto two = [](const P &p) {
    const bool first  = p[0] < 1 && p[1] < 1 && p[dim - 1] < 1;
    const bool second = p[0] > 1 && p[0] < 2 && p[1] > 1 && p[1] < 2 &&
                        (dim == 2 || p[dim - 1] < 1);
    return first || second ? -1. : 1.;
  };
  const auto surface = LevelSet<dim>(two).choose(body).faces;
  std::cout << dim << "D, two that touch: " << surface.size() << " faces";
  for (const auto &point : find_branchings(body, surface))
    std::cout << ", branching at (" << point << ")";
  std::cout << std::endl;
}


/** Faces in any order and from any side; two surfaces in one group. */
template <int dim>
void
test_groups()
{
  const auto body = cubes<dim>({{4, 3, 2}});
  using P         = Point<dim>;
  std::vector<EntityKey> keys;
  for (const unsigned int boundary : {3, 1})
    for (const auto &face : LayerBoundary<dim>(0, boundary).choose(body).faces)
      keys.push_back(body.mesh.face_key(face.plus));
  std::rotate(keys.begin(), keys.begin() + 4, keys.end());
  // Cells between the two are on the plus side of one, minus of the other.
  const auto surface = GroupOfFaces<dim>(keys).choose(body);
  bool upwards       = surface.faces.size() == keys.size();
  for (const auto &face : surface.faces)
    upwards = upwards && face.plus.first == face.minus.first + 1;
  check("two planes, plus where x is larger", upwards);

  const auto refuse = [&](const std::vector<EntityKey> &keys) {
    try
      {
        GroupOfFaces<dim>(keys).choose(body);
        std::cout << "FAILED: accepted" << std::endl;
      }
    catch (const std::runtime_error &error)
      {
        std::cout << error.what() << std::endl;
      }
  };
  refuse({body.mesh.face_key({0, 0})});
  const auto partly =
    GroupOfFaces<dim>({keys[0], body.mesh.face_key({0, 0})}).choose(body);
  check("what is open already is left out",
        partly.faces.size() == 1 && partly.n_open == 1);
  // What is in both groups is plus, what is in none has no face.
  std::vector<unsigned int> minus, plus;
  for (unsigned int cell = 0; cell < body.mesh.cells.size(); ++cell)
    {
      const P center = body.mesh.cell_center(cell);
      if (center[0] < 2)
        minus.push_back(cell);
      if (center[0] > 1 && center[1] < 2)
        plus.push_back(cell);
    }
  compare<dim>(
    "interface", body, Interface<dim>(minus, plus), 0, [](const P &p) {
      return p[0] > 1 && p[1] < 2 ? 1 : p[0] < 2 ? -1 : 0;
    });
  compare<dim>(
    "the other way", body, Interface<dim>({0, 1}, {2, 3}), 0, [](const P &p) {
      return p[1] > 1 || p[dim - 1] > 1 ? 0 : p[0] < 2 ? -1 : 1;
    });
}


/** A band of hexahedra in two layers that is closed to a ring after a number of
 * half turns; and the faces between the layers. */
void
test_band(const unsigned int n_half_turns)
{
  constexpr unsigned int n = 12;
  Body<3> body;
  const auto vertex = [&](unsigned int s, unsigned int w, unsigned int h) {
    if (s == n && n_half_turns % 2 == 1)
      w = 1 - w, h = 2 - h;
    return (s % n) * 6 + w * 3 + h;
  };
  for (unsigned int s = 0; s < n; ++s)
    for (unsigned int w = 0; w < 2; ++w)
      for (unsigned int h = 0; h < 3; ++h)
        {
          const double t = 2 * numbers::PI * s / n, turn = n_half_turns * t / 2;
          const double across = 0.3 * (w - 0.5), up = 0.3 * (h - 1.);
          const double out = std::cos(turn) * across - std::sin(turn) * up;
          body.mesh.vertices.emplace_back((2 + out) * std::cos(t),
                                          (2 + out) * std::sin(t),
                                          std::sin(turn) * across +
                                            std::cos(turn) * up);
        }
  std::vector<EntityKey> keys;
  for (unsigned int s = 0; s < n; ++s)
    for (unsigned int h = 0; h < 2; ++h)
      {
        body.mesh.cells.emplace_back();
        for (unsigned int v = 0; v < 8; ++v)
          body.mesh.cells.back().vertices[v] =
            vertex(s + v / 2 % 2, v % 2, h + v / 4);
        if (h == 0)
          keys.push_back(body.mesh.face_key({2 * s, 5}));
      }
  std::cout << n_half_turns << " half turns: ";
  try
    {
      const auto surface  = GroupOfFaces<3>(keys).choose(body);
      unsigned int n_same = 0;
      for (const auto &face : surface.faces)
        n_same += face.plus.first % 2 == surface.faces[0].plus.first % 2;
      std::cout << surface.faces.size() << " faces, " << n_same
                << " of the same side" << std::endl;
    }
  catch (const std::runtime_error &error)
    {
      std::cout << error.what() << std::endl;
    }
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_planes<2>();
    test_planes<3>();
    test_closed<2>();
    test_closed<3>();
    test_groups<2>();
    test_groups<3>();
    for (const unsigned int n_half_turns : {0, 1, 2, 3})
      test_band(n_half_turns);
  });
}
