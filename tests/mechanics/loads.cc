// SPDX-License-Identifier: LGPL-2.1-or-later
// The consistent nodal forces of pressures, tractions and body forces on
// serendipity elements, and how forces on nodes are shared.

#include <setsudan/mechanics/loads.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "../body/detach.h"
#include "../test_setup.h"
#include "small_model.h"

using namespace Setsudan;
using namespace dealii;

/** Add up the forces of a body's nodes, by their numbers. */
template <int dim>
std::map<unsigned int, Tensor<1, dim>>
forces_by_number(const SmallModel<dim> &small)
{
  std::map<unsigned int, Tensor<1, dim>> forces;
  std::set<types::global_dof_index> seen;
  const auto &discretization = small.model.discretization;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    {
      const auto nodes = discretization.node_indices(cell);
      for (unsigned int node = 0; node < nodes.size(); ++node)
        for (unsigned int c = 0; c < dim; ++c)
          if (seen.insert(nodes[node][c]).second)
            forces[small.body.node_numbers[discretization.element(cell)][node]]
                  [c] += small.model.loads(nodes[node][c]);
    }
  return forces;
}


template <int dim>
Tensor<1, dim>
resultant(const SmallModel<dim> &small)
{
  Tensor<1, dim> sum;
  for (const auto &[number, force] : forces_by_number(small))
    sum += force;
  for (unsigned int d = 0; d < dim; ++d)
    if (std::abs(sum[d]) < 1e-12)
      sum[d] = 0;
  return sum;
}


/** Print the last component of the forces on one element: in the order of the
 * nodes' numbers, and 0 for round-off. */
template <int dim>
void
print_element(const std::string &load)
{
  const SmallModel<dim> small(
    {dim == 3 ? "Body/Size=1,1,1" : "Body/Size=1,1",
     dim == 3 ? "Body/Elements=1,1,1" : "Body/Elements=1,1",
     load});
  std::cout << dim << "D, " << load << ":";
  double others = 0;
  for (const auto &[number, force] : forces_by_number(small))
    {
      const double last = force[dim - 1];
      std::cout << " " << (std::abs(last) < 1e-14 ? 0. : last);
      for (unsigned int d = 0; d < dim - 1; ++d)
        others = std::max(others, std::abs(force[d]));
    }
  std::cout << std::endl;
  check_below("other components", others, 1e-14);
}


/** The sum over a body of 2 x 3 x 4 (in 2D 2 x 3) with several elements. */
template <int dim>
void
print_resultant(const std::string &load)
{
  const SmallModel<dim> small(
    {dim == 3 ? "Body/Size=2,3,4" : "Body/Size=2,3",
     dim == 3 ? "Body/Elements=2,1,3" : "Body/Elements=3,2",
     load});
  std::cout << dim << "D, " << load << ": resultant " << resultant(small)
            << std::endl;
}


/** A force on a node is its own; after the elements 1 and 3 of a 2 x 2 x 1 body
 * got vertices of their own, they take their half of it with them. */
void
test_nodal_forces()
{
  const Assignments assignments = {"Body/Elements=2,2,1",
                                   "Load/Nodal forces=10: 1, 2, 4; 0: 0, 0, 8"};
  const SmallModel<3> small(assignments);
  for (const auto &[number, force] : forces_by_number(small))
    if (force.norm() > 0)
      std::cout << "node " << number << ": " << force << std::endl;

  const CoarseMesh<3> split = detach<3>(small.body.mesh, {1, 3});
  const SmallModel<3> cut(assignments, &split);
  std::set<types::global_dof_index> seen;
  const auto &discretization = cut.model.discretization;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    for (const auto &node : discretization.node_indices(cell))
      if (seen.insert(node[2]).second && cut.model.loads(node[2]) != 0)
        std::cout << "of element " << discretization.element(cell) << ": "
                  << cut.model.loads(node[0]) << " " << cut.model.loads(node[1])
                  << " " << cut.model.loads(node[2]) << std::endl;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    print_element<3>("Load/Pressures=top:1");
    print_element<3>("Load/Tractions=bottom:0,0,6");
    print_element<3>("Load/Body force=0,0,1");
    print_element<2>("Load/Pressures=top:1");
    print_element<2>("Load/Tractions=bottom:0,6");
    print_element<2>("Load/Body force=0,1");
    print_resultant<3>("Load/Pressures=left:1; back:10; top:100");
    print_resultant<3>(
      "Load/Pressures=left:1;right:1;front:1;back:1;bottom:1;top:1");
    print_resultant<3>("Load/Tractions=right:1,2,3; top:0,0,-1");
    print_resultant<3>("Load/Body force=1,2,-3");
    print_resultant<3>("Load/Nodal forces=0: 1,2,3; 7: 0,0,1; 50: 1,0,0");
    print_resultant<3>("Load/Pressures=");
    print_resultant<2>("Load/Pressures=left:1; top:10");
    print_resultant<2>("Load/Body force=1,-2");
    test_nodal_forces();
  });
}
