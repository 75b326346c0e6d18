// SPDX-License-Identifier: LGPL-2.1-or-later
// Refinement near cuts: cells at the cuts and up to a distance from them are
// small enough, both sides of a cut are alike, and the mesh that has been cut
// gets the same cells from the record.

#include <setsudan/cut/surface/mesh_surgery.h>
#include <setsudan/cut/surface/near_cut.h>
#include <setsudan/mesh/point_name.h>
#include <setsudan/simulation/scene.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

/** All active cells of a refined mesh of the body, of all processes. */
template <int dim>
std::set<CellPath>
cells_of(const CoarseMesh<dim> &mesh, const Refinement &refinement)
{
  parallel::distributed::Triangulation<dim> triangulation(MPI_COMM_WORLD);
  create_triangulation(mesh, triangulation);
  refine<dim>(triangulation, refinement);
  std::vector<CellPath> own;
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
      own.push_back(path_of_cell<dim>(cell));
  std::set<CellPath> all;
  for (const auto &part : Utilities::MPI::all_gather(MPI_COMM_WORLD, own))
    all.insert(part.begin(), part.end());
  return all;
}


template <int dim>
unsigned int
level_of(const CellPath &path)
{
  unsigned int level = 0;
  for (std::uint64_t digits = path.path; digits > 1; digits >>= dim)
    ++level;
  return level;
}


/** The centers of the faces that cells have on one side of a cut, by name. */
template <int dim>
std::set<PointName>
faces_on_side(const Body<dim> &body,
              const std::set<CellPath> &cells,
              const CellFace &side)
{
  Point<dim> center;
  for (unsigned int d = 0; d < dim; ++d)
    center[d] = d == side.second / 2 ? side.second % 2 : 0.5;
  std::set<PointName> names;
  for (auto cell = cells.lower_bound({side.first, 0});
       cell != cells.end() && cell->element == side.first;
       ++cell)
    {
      const auto point = point_in_element<dim>(*cell, center);
      if (point[side.second / 2] == side.second % 2)
        names.insert(name_of_point(body.mesh, side.first, point));
    }
  return names;
}


/** The smallest level of cells that have a corner where `is_near`. */
template <int dim>
unsigned int
smallest_level(const Body<dim> &body,
               const std::set<CellPath> &cells,
               const std::function<bool(const Point<dim> &)> &is_near)
{
  unsigned int smallest = 100;
  for (const auto &path : cells)
    for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_cell; ++v)
      {
        const auto point =
          point_in_element<dim>(path, GeometryInfo<dim>::unit_cell_vertex(v));
        const auto corner =
          body.mesh.vertices[body.mesh.cells[path.element].vertices[0]];
        const auto opposite =
          body.mesh.vertices[body.mesh.cells[path.element].vertices.back()];
        Point<dim> position;
        for (unsigned int d = 0; d < dim; ++d)
          position[d] = corner[d] + point[d] * (opposite[d] - corner[d]);
        if (is_near(position))
          smallest = std::min(smallest, level_of<dim>(path));
      }
  return smallest;
}


/** @param is_near whether a point is within the width of a cut. */
template <int dim>
void
test(const std::vector<SceneEntry> &entries,
     const std::function<bool(const Point<dim> &)> &is_near)
{
  std::vector<SceneEntry> all = {
    {"Body", "Elements", dim == 3 ? "4,4,2" : "4,4", ""},
    {"Body", "Size", dim == 3 ? "4,4,2" : "4,4", ""},
    {"Support", "Fixed faces", "bottom", ""}};
  all.insert(all.end(), entries.begin(), entries.end());
  const Parameters parameters("test", all, Scene<dim>::declare);
  const Scene<dim> scene(parameters);
  const Refinement refinement = refine_near_cuts(
    scene.body, scene.cut, scene.body_parameters.refinement, MPI_COMM_WORLD);
  const auto cells = cells_of(scene.body.mesh, refinement);

  CoarseMesh<dim> cut = scene.body.mesh;
  bool alike = true, fine_enough = true;
  const unsigned int level =
    scene.body_parameters.refinement + scene.cut.near_cut_levels;
  for (const auto &one : scene.cut.cuts)
    {
      cut = split_mesh(cut, one.surface.faces);
      for (const auto &face : one.surface.faces)
        {
          const auto minus = faces_on_side(scene.body, cells, face.minus);
          const auto plus  = faces_on_side(scene.body, cells, face.plus);
          alike            = alike && minus == plus;
          fine_enough =
            fine_enough && minus.size() >= std::pow(2, level * (dim - 1));
        }
    }
  const bool same             = cells_of(cut, refinement) == cells;
  const unsigned int smallest = smallest_level(scene.body, cells, is_near);
  if (!is_first_process())
    return;
  std::cout << dim << "D";
  for (const auto &entry : entries)
    std::cout << ", " << entry.name << " = " << entry.value;
  std::cout << ": " << cells.size() << " cells, "
            << (alike ? "" : "FAILED: not ") << "alike on both sides, "
            << (fine_enough ? "" : "FAILED: not ") << "fine at the cuts, "
            << (smallest >= level ? "" : "FAILED: not ")
            << "fine within the width, " << (same ? "" : "FAILED: not ")
            << "the same when it is cut" << std::endl;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    const SceneEntry x2{"Cut", "Surfaces", "x:2", ""};
    const auto levels = [](const std::string &value) {
      return SceneEntry{"Cut", "Refinement near cut", value, ""};
    };
    const SceneEntry slit{"Cut", "Extent", "depth:2", ""};
    const SceneEntry twice{"Body", "Refinement", "1", ""};
    const auto at_x2 = [](const double width) {
      return [width](const Point<2> &p) { return std::abs(p[0] - 2) <= width; };
    };
    test<2>({x2}, at_x2(0));
    test<2>({x2, levels("1")}, at_x2(0));
    test<2>({x2, levels("3")}, at_x2(0));
    test<2>({x2, levels("2, 0.6")}, at_x2(0.6));
    test<2>({x2, levels("1"), twice}, at_x2(0));
    // Around the end of a slit as well.
    test<2>({x2, levels("3"), slit},
            [](const Point<2> &p) { return p[0] == 2 && p[1] > 2; });
    test<2>({x2, levels("2, 0.5"), slit}, [](const Point<2> &p) {
      return std::hypot(p[0] - 2, std::min(0., p[1] - 2)) <= 0.5;
    });

    const auto at_both = [](const Point<3> &p) {
      return p[0] == 2 || p[1] == 1;
    };
    test<3>({x2, levels("2")}, [](const Point<3> &p) { return p[0] == 2; });
    test<3>({{"Cut", "Surfaces", "x:2; y:1", ""}, levels("2")}, at_both);
    test<3>({{"Cut", "Surfaces", "x:2; y:1", ""},
             {"Cut", "Extent", "all; box: 0, 0, 0, 2, 4, 4", ""},
             levels("2, 0.1")},
            [](const Point<3> &p) {
              return std::abs(p[0] - 2) <= 0.1 ||
                     (std::abs(p[1] - 1) <= 0.1 && p[0] <= 2);
            });
  });
}
