// SPDX-License-Identifier: LGPL-2.1-or-later
// Boxes that are diced by one cut after another, in all orders: the dice are
// boxes, with all that boxes have.

#include <setsudan/cut/surface/mesh_surgery.h>
#include <setsudan/cut/surface/surface_choice.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <tuple>

#include "../test_setup.h"
#include "topology.h"

using namespace Setsudan;
using namespace dealii;

struct LayerCut
{
  unsigned int axis;
  unsigned int boundary;

  bool
  operator<(const LayerCut &other) const
  {
    return std::tie(axis, boundary) < std::tie(other.axis, other.boundary);
  }
};


/** A box of elements, by the formulas. */
template <int dim>
Topology
topology_of_box(const std::array<unsigned int, dim> &n, const double volume)
{
  Topology box{1, 1, 0, 1, volume};
  for (unsigned int d = 0; d < dim; ++d)
    {
      box.n_cells *= n[d];
      box.n_vertices *= n[d] + 1;
    }
  for (unsigned int axis = 0; axis < dim; ++axis)
    box.n_nodes += box.n_vertices / (n[axis] + 1) * n[axis];
  box.n_nodes += box.n_vertices;
  return box;
}


/** What is wrong after these cuts in this order; nothing, where all is well. */
template <int dim>
std::string
problem_of_dice(const Body<dim> &body,
                const std::vector<LayerCut> &cuts,
                const unsigned int n_pieces,
                const Topology &die)
{
  CoarseMesh<dim> mesh             = body.mesh;
  std::vector<unsigned int> pieces = find_pieces(mesh);
  for (const auto &cut : cuts)
    {
      const auto before = pieces;
      mesh              = split_mesh(
        mesh, LayerBoundary<dim>(cut.axis, cut.boundary).choose(body).faces);
      pieces = find_pieces(mesh, before);
      // What had the smallest cell of a piece keeps its number.
      for (unsigned int cell = 0; cell < pieces.size(); ++cell)
        if (std::find(before.begin(), before.end(), before[cell]) ==
              before.begin() + cell &&
            pieces[cell] != before[cell])
          return "a piece has lost its number";
    }
  const auto dice = topology_of_pieces(mesh, pieces);
  if (dice.size() != n_pieces)
    return std::to_string(dice.size()) + " pieces";
  for (const auto &found : dice)
    if (!(found == die) || std::abs(found.volume - die.volume) > 1e-10)
      {
        std::ostringstream text;
        text << found;
        return text.str();
      }
  if (mesh.vertices.size() != n_pieces * die.n_vertices)
    return "vertices that belong to no piece, or to several";
  return "";
}


template <int dim>
void
dice(const std::array<unsigned int, dim> &n_elements,
     const std::array<unsigned int, dim> &n_dice)
{
  Point<dim> size;
  unsigned int n_pieces = 1;
  double volume         = 1;
  std::array<unsigned int, dim> n_of_die;
  std::vector<LayerCut> cuts;
  for (unsigned int d = 0; d < dim; ++d)
    {
      size[d]     = 10 + d;
      n_of_die[d] = n_elements[d] / n_dice[d];
      n_pieces *= n_dice[d];
      volume *= size[d] / n_dice[d];
      for (unsigned int i = 1; i < n_dice[d]; ++i)
        cuts.push_back({d, i * n_of_die[d]});
    }
  const Body<dim> body = make_box<dim>(size, n_elements);
  const Topology die   = topology_of_box<dim>(n_of_die, volume);

  unsigned int n_orders = 0;
  std::set<std::string> problems;
  do
    {
      ++n_orders;
      problems.insert(problem_of_dice(body, cuts, n_pieces, die));
    }
  while (std::next_permutation(cuts.begin(), cuts.end()));
  std::cout << n_pieces << " dice of " << die << ": " << n_orders << " orders"
            << std::endl;
  for (const auto &problem : problems)
    if (!problem.empty())
      std::cout << "FAILED: " << problem << std::endl;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    dice<3>({{4, 4, 4}}, {{2, 2, 2}});
    dice<3>({{3, 3, 3}}, {{3, 3, 3}});
    dice<3>({{2, 4, 3}}, {{2, 2, 1}});
    dice<2>({{4, 4}}, {{4, 2}});
    dice<2>({{3, 3}}, {{3, 3}});
  });
}
