// SPDX-License-Identifier: LGPL-2.1-or-later
// Pieces as bodies of their own: parts of a box have the numbers of a box, and
// groups are those of the body, with the faces that the cut has opened. What is
// written for gmsh is read as the same body.

#include <setsudan/body/gmsh/gmsh_file.h>
#include <setsudan/cut/surface/mesh_surgery.h>
#include <setsudan/cut/surface/surface_choice.h>
#include <setsudan/mesh/pieces.h>
#include <setsudan/output/pieces/piece_mesh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "../mechanics/small_model.h"
#include "../parameters/check.h"
#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

/** A body of 4 x 2 (x 2) elements of 2.5 x 5 (x 5), with a group of elements
 * and one of lines (in 2D of vertices) more. */
template <int dim>
Body<dim>
make_body()
{
  Body<dim> body =
    SmallBody<dim>({dim == 3 ? "Body/Elements=4,2,2" : "Body/Elements=4,2"})
      .body;
  body.groups.push_back({"core", 20, dim, {0, 2, 3}, {}});
  // Vertices are numbered x fastest: the second and third at the origin.
  const auto key = [](const std::vector<unsigned int> &vertices) {
    return make_entity_key(vertices);
  };
  if (dim == 3)
    body.groups.push_back({"edge", 21, 1, {}, {key({1, 2}), key({2, 3})}});
  else
    body.groups.push_back({"edge", 21, 0, {}, {key({1}), key({2})}});
  return body;
}


template <int dim>
void
print_groups(const PieceMesh<dim> &piece)
{
  std::cout << "  groups:";
  for (const auto &group : piece.groups)
    std::cout << " " << group.name << " (" << group.number << ", "
              << group.dimension << "D) " << group.entities.size();
  std::cout << std::endl;
}


/** Half of the box is a box, from x = 0 or 5. */
template <int dim>
void
compare_with_box(const PieceMesh<dim> &piece, const double start)
{
  const SmallBody<dim> half(
    {dim == 3 ? "Body/Elements=2,2,2" : "Body/Elements=2,2",
     dim == 3 ? "Body/Size=5,10,10" : "Body/Size=5,10",
     "Body/Translate=" + short_text(start) + (dim == 3 ? ",0,0" : ",0")});
  const Body<dim> &box = half.body;
  double error         = 0;
  for (unsigned int element = 0; element < piece.elements.size(); ++element)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      error = std::max(error,
                       box.mesh.node_position(element, node)
                         .distance(piece.nodes[piece.elements[element][node]]));
  check("  numbers of a box",
        piece.nodes.size() == box.n_nodes() &&
          std::equal(piece.elements.begin(),
                     piece.elements.end(),
                     box.node_numbers.begin(),
                     box.node_numbers.end()));
  check_below("  nodes of a box", error, 1e-13);
  check_below(
    "  volume", std::abs(piece.volume() - std::pow(10, dim) / 2), 1e-10);
}


/** The numbers that a piece has of the body are of the same nodes. */
template <int dim>
void
compare_with_body(const PieceMesh<dim> &piece, const Body<dim> &body)
{
  bool same =
    std::is_sorted(piece.numbers_in_body.begin(), piece.numbers_in_body.end());
  for (unsigned int e = 0; e < piece.elements.size(); ++e)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      same = same && piece.numbers_in_body[piece.elements[e][node]] ==
                       body.node_numbers[piece.elements_in_body[e]][node];
  check("  numbers in the body", same);
}


/** Every face of the group `cut` lies at x = 5. */
template <int dim>
void
check_cut(const PieceMesh<dim> &piece)
{
  double error = 0;
  for (const auto &group : piece.groups)
    if (group.name == "cut")
      for (const auto &entity : group.entities)
        for (const unsigned int node : entity)
          error = std::max(error, std::abs(piece.nodes[node][0] - 5));
  check_below("  where the cut is", error, 1e-13);
}


/** Write a piece, and read it again: numbers are larger by 1, and entities
 * without other groups are in that of the piece. */
template <int dim>
void
test_file(const PieceMesh<dim> &piece)
{
  const OutputDirectory directory("pieces", MPI_COMM_WORLD);
  write_piece_msh(piece, directory, "piece_0.msh");
  const Body<dim> body = read_gmsh_file<dim>("pieces/piece_0.msh");
  bool same            = body.mesh.cells.size() == piece.elements.size() &&
              body.n_nodes() == piece.nodes.size();
  double error = 0;
  for (unsigned int e = 0; same && e < piece.elements.size(); ++e)
    {
      // An element may list its nodes from another corner.
      std::map<unsigned int, Point<dim>> nodes;
      for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
        nodes[body.node_numbers[e][node]] = body.mesh.node_position(e, node);
      for (const unsigned int node : piece.elements[e])
        {
          same  = same && nodes.count(node + 1) > 0;
          error = std::max(error, nodes[node + 1].distance(piece.nodes[node]));
        }
    }
  check("  read with the same numbers", same);
  check_below("  read with the same nodes", error, 1e-13);
  std::map<std::pair<unsigned int, std::string>, std::size_t> groups, expected;
  for (const auto &group : body.groups)
    groups[{group.dimension, group.name}] =
      group.cells.size() + group.entities.size();
  std::size_t n_others = piece.elements.size();
  for (const auto &group : piece.groups)
    {
      expected[{group.dimension, group.name}] = group.entities.size();
      if (group.dimension == dim)
        n_others -= group.entities.size();
    }
  expected[{dim, "piece"}] = n_others;
  check("  read with the same groups", groups == expected);
}


template <int dim>
void
test_halves()
{
  const Body<dim> body = make_body<dim>();
  const auto mesh =
    split_mesh(body.mesh, LayerBoundary<dim>(0, 2).choose(body).faces);
  const auto pieces = make_piece_meshes(mesh, find_pieces(mesh), body);
  for (unsigned int p = 0; p < pieces.size(); ++p)
    {
      std::cout << dim << "D, half " << p << std::endl;
      compare_with_box(pieces[p], 5. * p);
      compare_with_body(pieces[p], body);
      print_groups(pieces[p]);
      check_cut(pieces[p]);
      test_file(pieces[p]);
    }
}


/** A slit has two sides in one piece. */
template <int dim>
void
test_slit()
{
  Body<dim> body = make_body<dim>();
  // Faces that the body has called so already join those of the slit.
  body.groups.push_back({"cut", 30, dim - 1, {}, {body.mesh.face_key({0, 0})}});
  auto surface = LayerBoundary<dim>(0, 2).choose(body).faces;
  surface.erase(std::remove_if(surface.begin(),
                               surface.end(),
                               [&](const auto &face) {
                                 return body.mesh.cell_center(
                                          face.plus.first)[dim - 1] < 5;
                               }),
                surface.end());
  const auto mesh  = split_mesh(body.mesh, surface);
  const auto piece = make_piece_meshes(mesh, find_pieces(mesh), body).front();
  std::cout << dim << "D, slit: " << body.n_nodes() << " nodes in the body, "
            << piece.nodes.size() << " in the piece" << std::endl;
  compare_with_body(piece, body);
  print_groups(piece);
  test_file(piece);
}


/** A displacement of refined elements moves the nodes that the body had. */
template <int dim>
void
test_deformed(const Refinement &refinement)
{
  const Body<dim> body = make_body<dim>();
  const Discretization<dim> discretization(
    body.mesh, refinement, MPI_COMM_WORLD);
  const auto move = [](const Point<dim> &p) {
    Tensor<1, dim> u;
    u[0] = 0.1 * p[0] + 0.02 * p[1] * p[1];
    u[1] = -0.05 * p[dim - 1];
    return u;
  };
  const auto u = discretization.with_ghosts(nodal_values(discretization, move));
  PieceMesh<dim> piece =
    make_piece_meshes(body.mesh, find_pieces(body.mesh), body).front();
  const auto rest = piece.nodes;
  set_displacements(
    gather_displacements(discretization, body.mesh.cells.size(), u), piece);
  deform(piece);
  double error = 0;
  for (unsigned int node = 0; node < rest.size(); ++node)
    error = std::max(error,
                     piece.nodes[node].distance(rest[node] + move(rest[node])));
  check_below(std::to_string(dim) + "D, deformed", error, 1e-13);
}


template <int dim>
void
test()
{
  test_halves<dim>();
  test_slit<dim>();
  test_deformed<dim>({});
  test_deformed<dim>({1, {}});
  test_deformed<dim>({0, {{1, 1}, {1, 1 << dim}}});
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test<2>();
    test<3>();
  });
}
