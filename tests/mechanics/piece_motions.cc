// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid motions of pieces that are linked: which of them supports and links
// stop, singly or only all together, and which loads work in those that are
// left.

#include <setsudan/mechanics/pieces/piece_motions.h>

#include <string>

#include "../test_setup.h"
#include "small_model.h"

using namespace Setsudan;
using namespace dealii;

template <int dim>
using Links = std::vector<PieceLink<dim>>;

/** Two pieces move alike at a point. */
template <int dim>
Links<dim>
tied(const unsigned int a,
     const unsigned int b,
     const std::vector<Point<dim>> &points)
{
  Links<dim> links;
  for (const auto &point : points)
    for (unsigned int d = 0; d < dim; ++d)
      links.push_back(
        {{{a, b}}, point, Tensor<1, dim>(Point<dim>::unit_vector(d))});
  return links;
}

/** They move alike along a normal. */
template <int dim>
Links<dim>
opened(const unsigned int a,
       const unsigned int b,
       const Tensor<1, dim> &normal,
       const std::vector<Point<dim>> &points)
{
  Links<dim> links;
  for (const auto &point : points)
    links.push_back({{{a, b}}, point, normal});
  return links;
}

template <int dim>
Links<dim>
operator+(Links<dim> a, const Links<dim> &b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

template <int dim>
void
test(const std::string &name,
     const SmallModel<dim> &small,
     const Links<dim> &links)
{
  std::vector<unsigned int> pieces(small.body.mesh.cells.size());
  for (unsigned int cell = 0; cell < pieces.size(); ++cell)
    pieces[cell] = cell;
  const PieceMotions<dim> motions(small.body.mesh, pieces, small.supports);
  std::cout << dim << "D, " << name << ":";
  for (const auto &group : motions.find_floating(links))
    {
      for (const auto &loose : group.loose)
        std::cout << " " << loose.piece << " (" << loose.hold.size() << ")";
      try
        {
          check_loads_on_loose_group(small.model, pieces, group);
          std::cout << " in equilibrium;";
        }
      catch (const std::runtime_error &)
        {
          std::cout << " pushed;";
        }
    }
  std::cout << std::endl;
}

/** Three cubes in a row along x, of which the first stands on the ground. */
void
test_space()
{
  using P = Point<3>;
  const SmallModel<3> row({"Body/Elements=3,1,1",
                           "Body/Size=3,1,1",
                           "Support/Fixed boxes=0,0,0,0,1,1 : xyz"});
  const SmallModel<3> heavy({"Body/Elements=3,1,1",
                             "Body/Size=3,1,1",
                             "Support/Fixed boxes=0,0,0,0,1,1 : xyz",
                             "Load/Body force=0,0,-1"});
  const std::vector<P> first = {P(1, 0, 0), P(1, 1, 0), P(1, 0, 1), P(1, 1, 1)};
  const std::vector<P> second = {
    P(2, 0, 0), P(2, 1, 0), P(2, 0, 1), P(2, 1, 1)};
  const std::vector<P> third = {P(3, 0, 0), P(3, 1, 0)};
  const Tensor<1, 3> x       = Point<3>::unit_vector(0);
  const Tensor<1, 3> y       = Point<3>::unit_vector(1);
  const Tensor<1, 3> z       = Point<3>::unit_vector(2);

  test<3>("no links", row, {});
  test<3>("all tied", row, tied<3>(0, 1, first) + tied<3>(1, 2, second));
  test<3>("the last one free", row, tied<3>(0, 1, first));
  test<3>("the last two together", row, tied<3>(1, 2, second));
  test<3>("a hinge",
          row,
          tied<3>(0, 1, {first[0], first[1]}) + tied<3>(1, 2, second));
  test<3>("a thread", row, tied<3>(0, 1, {first[0]}));
  test<3>(
    "opened along x", row, opened<3>(0, 1, x, first) + tied<3>(1, 2, second));
  // The weight works where they slide down, and not where they lie.
  test<3>("heavy, opened along x",
          heavy,
          opened<3>(0, 1, x, first) + tied<3>(1, 2, second));
  test<3>("heavy, opened along z at both ends",
          heavy,
          opened<3>(0, 1, z, first) + opened<3>(0, 2, z, third) +
            tied<3>(1, 2, second));
  test<3>("opened all around",
          row,
          opened<3>(0, 1, x, first) + opened<3>(0, 1, y, {first[0], first[2]}) +
            opened<3>(0, 1, z, {first[0]}) + tied<3>(1, 2, second));
  // Three bodies hinged to each other along parallel lines: each two of them
  // can turn, all three cannot, unless the lines lie in a plane.
  const auto triangle = [&](const double height) {
    return tied<3>(0, 1, {P(1, 0, 0), P(1, 1, 0)}) +
           tied<3>(1, 2, {P(2, 0, height), P(2, 1, height)}) +
           tied<3>(2, 0, {P(3, 0, 0), P(3, 1, 0)});
  };
  test<3>("a triangle of hinges", row, triangle(1));
  test<3>("a flat triangle of hinges", row, triangle(0));
}

void
test_plane()
{
  using P = Point<2>;
  const SmallModel<2> row({"Body/Elements=3,1",
                           "Body/Size=3,1",
                           "Support/Fixed boxes=0,0,0,1 : xy",
                           "Load/Body force=0,-1"});
  const Tensor<1, 2> x = Point<2>::unit_vector(0);
  test<2>("no links", row, {});
  test<2>("tied", row, tied<2>(0, 1, {P(1, 0), P(1, 1)}));
  test<2>("opened along x", row, opened<2>(0, 1, x, {P(1, 0), P(1, 1)}));
}

int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_space();
    test_plane();
  });
}
