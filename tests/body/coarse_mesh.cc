// The elements of a body: faces are the same from both sides, cells that share
// a face are neighbors, and pieces are what hangs together by faces.

#include <setsudan/body/body.h>

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "../parameters/check.h"
#include "../test_setup.h"
#include "small_body.h"

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


/** Every face has one cell and a boundary id, or two cells and none. */
template <int dim>
void
test_faces(const CoarseMesh<dim> &mesh)
{
  std::map<FaceKey, std::vector<CellFace>> faces;
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    for (unsigned int face = 0; face < GeometryInfo<dim>::faces_per_cell;
         ++face)
      faces[mesh.face_key({cell, face})].push_back({cell, face});

  unsigned int n_boundary_faces = 0, n_wrong = 0;
  for (const auto &[key, sides] : faces)
    {
      const bool at_boundary = sides.size() == 1;
      n_boundary_faces += at_boundary;
      if (sides.size() > 2 || !std::is_sorted(key.begin(), key.end()))
        ++n_wrong;
      for (const auto &side : sides)
        if ((mesh.boundary_ids.count(side) > 0) != at_boundary)
          ++n_wrong;
    }
  std::cout << dim << "D: " << faces.size() << " faces, " << n_boundary_faces
            << " on the boundary, " << n_wrong << " wrong" << std::endl;
}


template <int dim>
void
test_neighbors(const CoarseMesh<dim> &mesh)
{
  const auto neighbors = collect_neighbors(mesh);
  bool symmetric       = true;
  unsigned int n_pairs = 0;
  for (unsigned int cell = 0; cell < neighbors.size(); ++cell)
    for (const unsigned int other : neighbors[cell])
      {
        ++n_pairs;
        symmetric = symmetric && std::count(neighbors[other].begin(),
                                            neighbors[other].end(),
                                            cell) == 1;
      }
  std::cout << "the corner cell's neighbors:";
  std::set<unsigned int> of_first(neighbors[0].begin(), neighbors[0].end());
  for (const unsigned int cell : of_first)
    std::cout << " " << cell;
  std::cout << "; neighbors of all cells: " << n_pairs << std::endl;
  check("neighbors are mutual", symmetric);
}


template <int dim>
void
test_volume(const CoarseMesh<dim> &mesh)
{
  double volume = 0;
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    volume += mesh.cell_volume(cell);
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


/** Give the cells `own` vertices of their own. */
template <int dim>
CoarseMesh<dim>
detach(CoarseMesh<dim> mesh, const std::set<unsigned int> &own)
{
  std::map<unsigned int, unsigned int> copies;
  for (const unsigned int cell : own)
    for (unsigned int &vertex : mesh.cells[cell].vertices)
      {
        const auto [copy, is_new] =
          copies.emplace(vertex, mesh.vertices.size());
        if (is_new)
          mesh.vertices.push_back(mesh.vertices[vertex]);
        vertex = copy->second;
      }
  return mesh;
}


/** A triangulation has the cells under the same numbers, and their ids. */
template <int dim>
void
test_triangulation(const CoarseMesh<dim> &mesh)
{
  Triangulation<dim> triangulation;
  create_triangulation(mesh, triangulation);
  double error  = triangulation.n_active_cells() == mesh.cells.size() ? 0 : 1;
  bool same_ids = true;
  for (const auto &cell : triangulation.active_cell_iterators())
    {
      error = std::max(
        error, cell->center().distance(mesh.cell_center(cell->index())));
      for (const unsigned int face : cell->face_indices())
        {
          const auto id = mesh.boundary_ids.find({cell->index(), face});
          if (id != mesh.boundary_ids.end())
            same_ids = same_ids && cell->face(face)->at_boundary() &&
                       cell->face(face)->boundary_id() == id->second;
        }
    }
  check_below("triangulation, distance of cells", error, 1e-13);
  check("triangulation, boundary ids", same_ids);
}


template <int dim>
void
test()
{
  const CoarseMesh<dim> &mesh = small_body<dim>().mesh;
  test_faces(mesh);
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
