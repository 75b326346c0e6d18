// SPDX-License-Identifier: LGPL-2.1-or-later
// Rows, board, edge and lever rule of the blade, without solving.

#include <setsudan/cut/seam/seam.h>
#include <setsudan/mesh/point_name.h>
#include <setsudan/simulation/cut_body.h>

#include <map>

#include "../test_setup.h"

using namespace Setsudan;

/** The number of each node by its name. */
std::map<PointName, unsigned int>
number_nodes(const Body<3> &body)
{
  std::map<PointName, unsigned int> numbers;
  for (unsigned int element = 0; element < body.mesh.cells.size(); ++element)
    for (unsigned int node = 0; node < n_element_nodes<3>; ++node)
      numbers[name_of_point(body.mesh, element, unit_point_of_node<3>(node))] =
        body.node_numbers[element][node];
  return numbers;
}

void
print_rows(const std::string &elements,
           const std::string &surface,
           const std::string &direction,
           const std::string &release)
{
  const Parameters parameters("test",
                              {{"Body", "Elements", elements, ""},
                               {"Support", "Fixed faces", "bottom", ""},
                               {"Cut", "Surfaces", surface, ""},
                               {"Blade", "Direction", direction, ""},
                               {"Division", "Release", release, ""}},
                              Scene<3>::declare);
  const Scene<3> scene(parameters);
  CutBody<3> body(scene, MPI_COMM_WORLD);
  body.begin_cut(scene.cut.cuts[0]);
  const auto numbers = number_nodes(scene.body);
  std::cout << elements << " " << surface << " along " << direction << ", "
            << release << ":" << std::endl;
  for (const auto &row : body.seam().rows())
    {
      std::cout << "  depth " << row.depth << ", " << row.pairs.size()
                << " nodes, front";
      for (const unsigned int pair : row.front)
        std::cout << " " << numbers.at(body.seam().pairs()[pair].name);
      std::cout << std::endl;
    }
}

/** How many faces an extent leaves of a cut. */
void
print_extent(const std::string &direction, const std::string &extent)
{
  const Parameters parameters("test",
                              {{"Body", "Elements", "2,4,4", ""},
                               {"Support", "Fixed faces", "bottom", ""},
                               {"Cut", "Surfaces", "y:2", ""},
                               {"Cut", "Extent", extent, ""},
                               {"Blade", "Direction", direction, ""}},
                              Scene<3>::declare);
  std::cout << extent << " along " << direction << ": "
            << Scene<3>(parameters).cut.cuts[0].surface.faces.size() << " faces"
            << std::endl;
}

/** The edge in a surface whose faces have these area vectors. */
template <int dim>
void
print_edge(const std::vector<dealii::Tensor<1, dim>> &areas,
           const dealii::Tensor<1, dim> &direction)
{
  const BladeEdge<dim> edge(areas, direction / direction.norm());
  dealii::Tensor<1, dim> vector;
  for (const auto &area : areas)
    vector += area;
  std::cout << "edge in (" << vector << "), on the way (" << direction
            << "): to (";
  for (unsigned int d = 0; d < dim; ++d)
    std::cout << (d == 0 ? "" : " ")
              << (std::abs(edge.direction[d]) < 1e-15 ? 0. : edge.direction[d]);
  std::cout << "), turned by " << edge.projection_angle << " degrees and "
            << (edge.angle_to_faces < 1e-12 ? 0. : edge.angle_to_faces)
            << " off the faces, along "
            << "xyz"[edge.axis] << std::endl;
}

void
test_edges()
{
  using T = dealii::Tensor<1, 3>;
  print_edge<3>({T({0, 4, 0})}, T({0, 0, -1}));
  print_edge<3>({T({0, 4, 0})}, T({0, 1, -1}));
  print_edge<3>({T({0, 4, 0})}, T({1, 0, -2}));
  print_edge<3>({T({0, 4, 0})}, T({0, -1, 0}));
  print_edge<3>({T({1, 1, 0}), T({2, -1, 0})}, T({0, 3, -1}));
  print_edge<3>({T({1, 1, 0})}, T({0, 0, -1}));
  print_edge<3>({T({1, 2, 0})}, T({0, 0, -1}));
  // Closed: nothing to be projected into.
  print_edge<3>({T({1, 0, 0}), T({-1, 0, 0})}, T({0, 1, -1}));
  // A cup: its areas sum up to that of the bottom, across which it is entered.
  print_edge<3>(
    {T({1, 0, 0}), T({-1, 0, 0}), T({0, 1, 0}), T({0, -1, 0}), T({0, 0, 1})},
    T({0, 0, -1}));
  print_edge<2>({dealii::Tensor<1, 2>({1, 1})}, dealii::Tensor<1, 2>({0, -1}));
}

int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    print_rows("1,2,1", "y:1", "0,0,-1", "node row");
    print_rows("2,2,2", "y:1", "0,0,-1", "node row");
    print_rows("2,2,2", "y:1", "0,0,-1", "element row");
    print_rows("2,2,2", "y:1", "-1,0,0", "element row");
    print_rows("2,2,2", "z:1", "0,1,0", "node row");

    // Depth is measured in the cut, whatever the blade's direction.
    print_extent("0,0,-1", "all");
    print_extent("0,0,-1", "depth : 5");
    print_extent("0,-0.99,-1", "depth : 5");

    test_edges();

    // Loads between, on and at the ends of the nodes 0, 1, 4, 10.
    const std::vector<EdgeLoad> loads = {
      {0, 1}, {.25, 8}, {4, 2}, {7, 6}, {10, 3}};
    const std::vector<double> nodes = {0, 1, 4, 10};
    std::vector<double> forces(nodes.size());
    double force = 0, moment = 0;
    for (const auto &load : loads)
      {
        force -= load.force;
        moment -= load.position * load.force;
      }
    for (const auto &share : share_edge_loads(loads, nodes))
      forces[share.node] += share.force;
    std::cout << "lever rule:";
    for (unsigned int n = 0; n < nodes.size(); ++n)
      {
        std::cout << " " << forces[n];
        force += forces[n];
        moment += nodes[n] * forces[n];
      }
    std::cout << std::endl;
    // Where an earlier cut crosses, two nodes share a position.
    std::vector<double> halves(4);
    for (const auto &share : share_edge_loads({{5, 8}, {4, 5}}, {0, 5, 5, 10}))
      halves[share.node] += share.force;
    std::cout << "crossing: " << halves[0] << " " << halves[1] << " "
              << halves[2] << " " << halves[3] << std::endl;
    check_below("force", std::abs(force), 1e-14);
    check_below("moment", std::abs(moment), 1e-13);
  });
}
