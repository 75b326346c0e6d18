// SPDX-License-Identifier: LGPL-2.1-or-later
// The mesh surgery on boxes: the numbers of vertices and boundary faces that it
// makes, the numbers of nodes on the two sides against the paper's formulas,
// and the fan rule at tips and crossings.

#include <setsudan/cut/seam/sides.h>
#include <setsudan/cut/surface/mesh_surgery.h>
#include <setsudan/cut/surface/surface_choice.h>
#include <setsudan/mesh/nodes.h>

#include <cmath>
#include <numeric>
#include <set>

#include "../test_setup.h"
#include "topology.h"

using namespace Setsudan;

template <int dim>
using Indices = typename BoxNumbering<dim>::Indices;

// A box with edges of length 10.
template <int dim>
Body<dim>
box(const Indices<dim> &n_elements)
{
  dealii::Point<dim> size;
  for (unsigned int d = 0; d < dim; ++d)
    size[d] = 10;
  return make_box<dim>(size, n_elements);
}

template <int dim>
CutSurface<dim>
layer_boundary(const Body<dim> &body,
               const unsigned int axis,
               const unsigned int boundary)
{
  return LayerBoundary<dim>(axis, boundary).choose(body).faces;
}

// Nodes of the uncut body that lie on the surface, as both sides see them.
template <int dim>
unsigned int
n_nodes_on(const Body<dim> &body, const CutSurface<dim> &surface)
{
  std::set<unsigned int> minus, plus;
  for (const auto &face : surface)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      {
        if (node_is_on_face<dim>(node, face.minus.second))
          minus.insert(body.node_numbers[face.minus.first][node]);
        if (node_is_on_face<dim>(node, face.plus.second))
          plus.insert(body.node_numbers[face.plus.first][node]);
      }
  AssertThrow(minus == plus, dealii::ExcMessage("The sides disagree."));
  return plus.size();
}

// Distinct nodes (vertices and edges) of a mesh.
template <int dim>
unsigned int
n_nodes_of(const CoarseMesh<dim> &mesh)
{
  std::vector<unsigned int> cells(mesh.cells.size());
  std::iota(cells.begin(), cells.end(), 0);
  return topology_of(mesh, cells).n_nodes;
}

template <int dim>
void
cut_box(const Indices<dim> &elements)
{
  const Body<dim> body = box<dim>(elements);
  for (unsigned int axis = 0; axis < dim; ++axis)
    for (unsigned int dn = 1; dn < elements[axis]; ++dn)
      {
        const auto surface = layer_boundary(body, axis, dn);
        const auto split   = split_mesh(body.mesh, surface);
        const auto sides   = find_sides(split, surface);
        const auto pieces  = find_pieces(split);
        for (unsigned int e = 0; e < sides.size(); ++e)
          {
            const bool behind = body.box->element_indices(e)[axis] >= dn;
            AssertThrow(sides[e] == (behind ? 1 : -1) &&
                          pieces[e] == (behind ? 1u : 0u),
                        dealii::ExcMessage("An element on the wrong side."));
          }
        AssertThrow(joined_faces(body.mesh, surface).size() == surface.size() &&
                      joined_faces(split, surface).empty(),
                    dealii::ExcMessage("A face is not opened."));
        // The area of a face of the box, and its normal along the axis.
        const double size = dim == 3 ? 100 : 10;
        const auto area   = measure_surface(body, surface);
        AssertThrow(
          std::abs(area.area - size) < 1e-10 &&
            (area.vector - size * dealii::Point<dim>::unit_vector(axis))
                .norm() < 1e-10,
          dealii::ExcMessage("The surface has a wrong area."));
        // The paper's counts of the nodes of a layer, see section 3.3.
        auto n                = elements;
        unsigned int expected = 1;
        if constexpr (dim == 2)
          expected = 2 * n[1 - axis] + 1;
        else
          {
            const unsigned int a = n[(axis + 1) % 3], b = n[(axis + 2) % 3];
            expected = (2 * a + 1) * (b + 1) + (a + 1) * b;
          }
        std::cout << "xyz"[axis] << ":" << dn << " vertices "
                  << body.mesh.vertices.size() << " -> "
                  << split.vertices.size() << ", boundary faces "
                  << n_boundary_faces(body.mesh) << " -> "
                  << n_boundary_faces(split) << ", nodes "
                  << n_nodes_of(body.mesh) << " -> " << n_nodes_of(split)
                  << ", on the cut " << n_nodes_on(body, surface)
                  << ", by the paper " << expected << std::endl;
      }
}

int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    cut_box<3>({{2, 4, 4}});
    cut_box<3>({{1, 2, 1}});
    cut_box<3>({{3, 2, 2}});
    cut_box<2>({{3, 2}});

    // A slit: the two upper layers of faces only. Its tip stays joined.
    const Body<3> body = box<3>({{2, 4, 4}});
    auto slit          = layer_boundary(body, 1, 2);
    slit.erase(std::remove_if(slit.begin(),
                              slit.end(),
                              [&](const CutFace<3> &face) {
                                return body.box->element_indices(
                                         face.plus.first)[2] < 2;
                              }),
               slit.end());
    const auto opened = split_mesh(body.mesh, slit);
    std::cout << "slit: vertices " << opened.vertices.size()
              << ", boundary faces " << n_boundary_faces(opened) << ", pieces "
              << 1 + find_pieces(opened).back() << std::endl;

    // Crossing cuts: four copies along the crossing, all in all four pieces.
    auto cross = split_mesh(body.mesh, layer_boundary(body, 1, 2));
    cross      = split_mesh(cross, layer_boundary(body, 0, 1));
    std::cout << "cross: vertices " << cross.vertices.size() << ", pieces "
              << 1 + find_pieces(cross).back() << std::endl;
  });
}
