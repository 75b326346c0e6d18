// SPDX-License-Identifier: LGPL-2.1-or-later
// Node numbers of boxes: one for each node and each for one node, in the order
// of the nodes' positions, and the same from every element.

#include <setsudan/body/body.h>
#include <setsudan/mesh/nodes.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../parameters/check.h"
#include "../test_setup.h"
#include "small_body.h"

using namespace Setsudan;
using namespace dealii;

/** Half-indices of all nodes of a box, x fastest, then y, then z. */
template <int dim>
std::vector<std::array<unsigned int, dim>>
all_half_indices(const std::array<unsigned int, dim> &n_elements)
{
  std::vector<std::array<unsigned int, dim>> nodes;
  const unsigned int last_k = dim == 3 ? 2 * n_elements[dim - 1] : 0;
  for (unsigned int k = 0; k <= last_k; ++k)
    for (unsigned int j = 0; j <= 2 * n_elements[1]; ++j)
      for (unsigned int i = 0; i <= 2 * n_elements[0]; ++i)
        if (i % 2 + j % 2 + k % 2 <= 1)
          {
            nodes.push_back({{i, j}});
            if (dim == 3)
              nodes.back()[dim - 1] = k;
          }
  return nodes;
}


/** Nodes in the order of their positions are numbered one by one: so the
 * numbering is a bijection onto 0, ..., n - 1. */
template <int dim>
void
test_order(const BoxNumbering<dim> &numbering)
{
  const auto nodes = all_half_indices<dim>(numbering.n_elements);
  bool in_order    = true;
  for (unsigned int n = 0; n < nodes.size(); ++n)
    in_order = in_order && numbering.node_number(nodes[n]) == n;
  std::cout << numbering.n_nodes() << " nodes" << std::endl;
  check("as many as there are", nodes.size() == numbering.n_nodes());
  check("numbered in order", in_order);
}


/** The number that an element gives its node is that of the node's position,
 * and elements are numbered in the order of their positions. */
template <int dim>
void
test_elements(const Body<dim> &body, const Point<dim> &size)
{
  const auto &numbering = *body.box;
  const auto nodes      = all_half_indices<dim>(numbering.n_elements);
  double error          = 0;
  bool inverse          = true;
  bool same             = true;
  std::vector<bool> touched(nodes.size(), false);
  for (unsigned int element = 0; element < body.mesh.cells.size(); ++element)
    {
      const auto indices = numbering.element_indices(element);
      inverse = inverse && numbering.element_number(indices) == element;
      for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
        {
          const unsigned int number = numbering.node_number(element, node);
          touched.at(number)        = true;
          same = same && body.node_numbers[element][node] == number;
          Point<dim> position;
          for (unsigned int d = 0; d < dim; ++d)
            position[d] =
              size[d] * nodes[number][d] / (2. * numbering.n_elements[d]);
          error = std::max(
            error, position.distance(body.mesh.node_position(element, node)));
        }
      for (unsigned int d = 0; d < dim; ++d)
        error = std::max(
          error,
          std::abs(body.mesh.cell_center(element)[d] -
                   size[d] * (indices[d] + 0.5) / numbering.n_elements[d]));
    }
  check("every node is an element's",
        std::count(touched.begin(), touched.end(), false) == 0);
  check("element numbers and indices agree", inverse);
  check("the body has these numbers", same && body.n_nodes() == nodes.size());
  check("and no others",
        body.has_node(nodes.size() - 1) && !body.has_node(nodes.size()));
  check_below("distance of nodes from where they should be", error, 1e-13);
}


template <int dim>
void
test(const std::string &n_elements)
{
  std::cout << n_elements << ": ";
  Point<dim> size;
  for (unsigned int d = 0; d < dim; ++d)
    size[d] = d + 1;
  const SmallBody<dim> small({"Body/Elements=" + n_elements,
                              dim == 3 ? "Body/Size=1,2,3" : "Body/Size=1,2"});
  test_order(*small.body.box);
  test_elements(small.body, size);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for (const char *n_elements :
         {"1, 1, 1", "1, 2, 1", "2, 1, 1", "1, 1, 2", "2, 3, 4", "4, 2, 3"})
      test<3>(n_elements);
    for (const char *n_elements : {"1, 1", "3, 2", "2, 5"})
      test<2>(n_elements);
  });
}
