// The mesh surgery on boxes: the numbers of vertices and boundary faces that it
// makes, the numbers of nodes on the two sides against the paper's formulas,
// and the fan rule at tips and crossings.

#include <setsudan/body/nodes.h>
#include <setsudan/cut/mesh_surgery.h>
#include <setsudan/cut/sides.h>

#include <set>

#include "../test_setup.h"

using namespace Setsudan;

template <int dim>
Body<dim>
make_box(const std::vector<std::string> &elements)
{
  std::string list = elements[0];
  for (unsigned int d = 1; d < dim; ++d)
    list += "," + elements[d];
  const Parameters parameters(
    "test", {{"Body", "Elements", list, "test"}}, BodyParameters<dim>::declare);
  return Body<dim>(BodyParameters<dim>(parameters));
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
          minus.insert(body.numbering.node_number(face.minus.first, node));
        if (node_is_on_face<dim>(node, face.plus.second))
          plus.insert(body.numbering.node_number(face.plus.first, node));
      }
  AssertThrow(minus == plus, dealii::ExcMessage("The sides disagree."));
  return plus.size();
}

// Distinct nodes (vertices and edges) of a mesh.
template <int dim>
unsigned int
n_nodes_of(const CoarseMesh<dim> &mesh)
{
  std::set<std::pair<unsigned int, unsigned int>> nodes;
  for (const auto &cell : mesh.cells)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      {
        const auto ends = vertices_of_node<dim>(node);
        nodes.insert(
          std::minmax(cell.vertices[ends[0]], cell.vertices[ends[1]]));
      }
  return nodes.size();
}

template <int dim>
void
cut_box(const std::vector<std::string> &elements)
{
  const Body<dim> body = make_box<dim>(elements);
  for (unsigned int axis = 0; axis < dim; ++axis)
    for (unsigned int dn = 1; dn < body.numbering.n_elements[axis]; ++dn)
      {
        const auto surface = make_cut_surface(body, {axis, dn, ""});
        const auto split   = split_mesh(body.mesh, surface);
        const auto sides   = find_sides(split, surface);
        const auto pieces  = find_pieces(split);
        for (unsigned int e = 0; e < sides.size(); ++e)
          {
            const bool behind = body.numbering.element_indices(e)[axis] >= dn;
            AssertThrow(sides[e] == (behind ? 1 : -1) &&
                          pieces[e] == (behind ? 1u : 0u),
                        dealii::ExcMessage("An element on the wrong side."));
          }
        // The paper's counts of the nodes of a layer, see section 3.3.
        auto n                = body.numbering.n_elements;
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
                  << body.mesh.boundary_ids.size() << " -> "
                  << split.boundary_ids.size() << ", nodes "
                  << n_nodes_of(body.mesh) << " -> " << n_nodes_of(split)
                  << ", on the cut " << n_nodes_on(body, surface)
                  << ", by the paper " << expected << std::endl;
      }
}

int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    cut_box<3>({"2", "4", "4"});
    cut_box<3>({"1", "2", "1"});
    cut_box<3>({"3", "2", "2"});
    cut_box<2>({"3", "2"});

    // A slit: the two upper layers of faces only. Its tip stays joined.
    const Body<3> body = make_box<3>({"2", "4", "4"});
    auto slit          = make_cut_surface(body, {1, 2, ""});
    slit.erase(std::remove_if(slit.begin(),
                              slit.end(),
                              [&](const CutFace<3> &face) {
                                return body.numbering.element_indices(
                                         face.plus.first)[2] < 2;
                              }),
               slit.end());
    const auto opened = split_mesh(body.mesh, slit);
    std::cout << "slit: vertices " << opened.vertices.size()
              << ", boundary faces " << opened.boundary_ids.size()
              << ", pieces " << 1 + find_pieces(opened).back() << std::endl;

    // Crossing cuts: four copies along the crossing, all in all four pieces.
    auto cross = split_mesh(body.mesh, make_cut_surface(body, {1, 2, ""}));
    cross      = split_mesh(cross, make_cut_surface(body, {0, 1, ""}));
    std::cout << "cross: vertices " << cross.vertices.size() << ", pieces "
              << 1 + find_pieces(cross).back() << std::endl;
  });
}
