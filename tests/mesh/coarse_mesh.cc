// SPDX-License-Identifier: LGPL-2.1-or-later
// The elements of a body: faces are the same from both sides, cells that share
// a face are neighbors, and pieces are what hangs together by faces.

#include <setsudan/body/body.h>
#include <setsudan/mesh/face_index.h>
#include <setsudan/mesh/geometry.h>
#include <setsudan/mesh/pieces.h>

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "../body/detach.h"
#include "../body/small_body.h"
#include "../parameters/check.h"
#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

template <int dim>
const Body<dim> &
small_body()
{
  static const SmallBody<dim> small(
    {dim == 3 ? "Body/Elements=2, 3, 4" : "Body/Elements=2, 3",
     dim == 3 ? "Body/Size=1, 2, 3" : "Body/Size=1, 2"});
  return small.body;
}


/** Every face has one cell and is in one group, or two cells and in none. */
template <int dim>
void
test_faces(const Body<dim> &body)
{
  const CoarseMesh<dim> &mesh = body.mesh;
  std::map<EntityKey, std::vector<CellFace>> faces;
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    for (unsigned int face = 0; face < GeometryInfo<dim>::faces_per_cell;
         ++face)
      faces[mesh.face_key({cell, face})].push_back({cell, face});
  std::map<EntityKey, unsigned int> n_groups;
  for (const auto &group : body.groups)
    for (const auto &entity : group.entities)
      ++n_groups[entity];

  const FaceIndex<dim> index(mesh);
  unsigned int n_boundary_faces = 0, n_wrong = 0;
  for (const auto &[key, sides] : faces)
    {
      const bool at_boundary = sides.size() == 1;
      n_boundary_faces += at_boundary;
      if (sides.size() > 2 || !std::is_sorted(key.begin(), key.end()) ||
          n_vertices(key) != GeometryInfo<dim>::vertices_per_face)
        ++n_wrong;
      if (n_groups[key] != (at_boundary ? 1 : 0) || index.find(key) != sides)
        ++n_wrong;
    }
  n_wrong += n_groups.size() != faces.size();
  std::cout << dim << "D: " << faces.size() << " faces, " << n_boundary_faces
            << " on the boundary, " << n_wrong << " wrong" << std::endl;
  check(
    "no other face is found",
    index.find(make_entity_key(std::vector<unsigned int>{0, 1, 1000})).empty());
}


/** The cell across a face has the same face. */
template <int dim>
void
test_neighbors(const CoarseMesh<dim> &mesh)
{
  const auto neighbors = collect_neighbors(mesh);
  bool symmetric = true, same_face = true;
  unsigned int n_pairs = 0;
  for (unsigned int cell = 0; cell < neighbors.size(); ++cell)
    for (unsigned int face = 0; face < neighbors[cell].size(); ++face)
      if (const unsigned int other = neighbors[cell][face];
          other != numbers::invalid_unsigned_int)
        {
          ++n_pairs;
          symmetric = symmetric && std::count(neighbors[other].begin(),
                                              neighbors[other].end(),
                                              cell) == 1;
          const auto back =
            std::find(neighbors[other].begin(), neighbors[other].end(), cell);
          const unsigned int other_face = back - neighbors[other].begin();
          same_face = same_face && mesh.face_key({cell, face}) ==
                                     mesh.face_key({other, other_face});
        }
  std::cout << "the corner cell's neighbors:";
  std::set<unsigned int> of_first(neighbors[0].begin(), neighbors[0].end());
  of_first.erase(numbers::invalid_unsigned_int);
  for (const unsigned int cell : of_first)
    std::cout << " " << cell;
  std::cout << "; neighbors of all cells: " << n_pairs << std::endl;
  check("neighbors are mutual", symmetric);
  check("across the same face", same_face);
}


template <int dim>
void
test_volume(const CoarseMesh<dim> &mesh)
{
  double volume = 0;
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    volume += volume_of_element(mesh.node_positions(cell));
  check_below("volume, error", std::abs(volume - (dim == 3 ? 6 : 2)), 1e-13);
  check_below("extent, error", std::abs(mesh.extent() - dim), 1e-13);
}


template <int dim>
void
print_pieces(const CoarseMesh<dim> &mesh)
{
  std::cout << "pieces:";
  for (const unsigned int piece : find_pieces(mesh))
    std::cout << " " << piece;
  std::cout << std::endl;
}


/** A triangulation has the cells under the same numbers, with their faces. */
template <int dim>
void
test_triangulation(const CoarseMesh<dim> &mesh)
{
  Triangulation<dim> triangulation;
  create_triangulation(mesh, triangulation);
  const auto neighbors = collect_neighbors(mesh);
  double error = triangulation.n_active_cells() == mesh.cells.size() ? 0 : 1;
  bool same_boundary = true;
  for (const auto &cell : triangulation.active_cell_iterators())
    {
      const unsigned int index = cell->index();
      error = std::max(error, cell->center().distance(mesh.cell_center(index)));
      for (const unsigned int face : cell->face_indices())
        {
          Point<dim> center;
          for (const unsigned int vertex : mesh.face_key({index, face}))
            if (vertex != numbers::invalid_unsigned_int)
              center += mesh.vertices[vertex] /
                        double(GeometryInfo<dim>::vertices_per_face);
          error = std::max(error, cell->face(face)->center().distance(center));
          same_boundary = same_boundary && cell->face(face)->at_boundary() ==
                                             (neighbors[index][face] ==
                                              numbers::invalid_unsigned_int);
        }
    }
  check_below("triangulation, distance of cells and faces", error, 1e-13);
  check("triangulation, boundary", same_boundary);
}


template <int dim>
void
test()
{
  const CoarseMesh<dim> &mesh = small_body<dim>().mesh;
  test_faces(small_body<dim>());
  test_neighbors(mesh);
  test_volume(mesh);
  print_pieces(mesh);
  // The middle layer, which leaves the two others apart; and a corner cell,
  // together with one that touches it in a vertex or edge only.
  print_pieces(detach<dim>(mesh, {2, 3}));
  print_pieces(detach<dim>(mesh, {0, 3}));
  test_triangulation(mesh);
  test_triangulation(detach<dim>(mesh, {2, 3}));
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test<2>();
    test<3>();
  });
}
