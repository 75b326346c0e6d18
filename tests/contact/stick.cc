// SPDX-License-Identifier: LGPL-2.1-or-later
// Columns of width b that a plate of thickness T presses against both walls of
// a cut, each hat's by itself: pushed to and fro, their shear stress is
//   theta = clip(theta + G dp/b, +-(mu sigma + a)),  sigma = M T / (2 b),
// it slips at p = (mu sigma + a) b / G, and the work is what the columns store
// and friction takes.

#include <setsudan/contact/contact_path.h>
#include <setsudan/simulation/cut_body.h>

#include <algorithm>
#include <cmath>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

constexpr double width = 0.5, half_thickness = 0.01, shear_modulus = 1 / 2.6,
                 modulus = 0.7 / (1.3 * 0.4);


/** What a vector of a column gives way under a force on itself; the vectors of
 * edge nodes do not. */
LAPACKFullMatrix<double>
products_of_columns(const ContactBasis<2> &basis)
{
  using Basis = ContactBasis<2>;
  LAPACKFullMatrix<double> products(basis.vectors().size() + 1);
  for (unsigned int h = 0; h < basis.hats().size(); ++h)
    for (const auto wall : {Basis::Wall::minus, Basis::Wall::plus})
      {
        const double slenderness = basis.hats()[h].area * width;
        const unsigned int out =
          basis.vector_of_hat(h, wall, Basis::Component::outward);
        const unsigned int along =
          basis.vector_of_hat(h, wall, Basis::Component::along);
        products(out, out)     = slenderness / modulus;
        products(along, along) = slenderness / shear_modulus;
      }
  return products;
}



/** The columns, and a plate that goes from place to place. */
struct Columns
{
  Columns(const CutBody<2> &body, const SlidingBlade &sliding)
    : sliding(sliding)
    , basis(body.model(),
            body.surface(),
            body.seam(),
            body.cut().edge,
            {sliding, true, true},
            {},
            nullptr)
    , products(products_of_columns(basis))
    , path(std::make_unique<ContactStage<2>>(
             basis,
             body.seam().rows().size(),
             0,
             products,
             UntouchedBody{{Vector<double>(basis.vectors().size()),
                            Vector<double>(basis.vectors().size())},
                           {}}),
           profile,
           sliding,
           1e-9)
  {
    profile.facets = {{-10., half_thickness, 0.}};
    for (const auto &hat : basis.hats())
      area += 2 * hat.area;
    path.begin(BladeMotion(), nullptr);
    limit =
      sliding.friction * modulus * half_thickness / width + sliding.adhesion;
    // It has been pushed here.
    stress = limit;
    energy = path.energy()(0);
  }

  double
  friction() const
  {
    return path.resultants().friction(travel);
  }

  void
  move_to(const double goal)
  {
    const int way = goal > travel ? 1 : -1;
    lost += path.head(way, travel);
    stress = std::clamp(
      stress + shear_modulus * (goal - travel) / width, -limit, limit);
    while (way * (goal - travel) > 0)
      {
        const double end =
          way > 0 ? std::min(path.end(), goal) : std::max(path.end(), goal);
        const auto force = path.resultants().flanks;
        work += (force(travel) + force(end)) / 2 * (end - travel);
        taken += path.friction_work(travel, end);
        travel = end;
        if (end != goal)
          {
            lost += path.cross_end();
            ends.push_back(end);
          }
      }
  }

  double
  imbalance() const
  {
    return work - taken - lost - (path.energy()(travel) - energy);
  }

  BladeProfile profile;
  const SlidingBlade sliding;
  const ContactBasis<2> basis;
  const LAPACKFullMatrix<double> products;
  ContactPath<2> path;
  double area = 0, limit = 0, stress = 0, energy = 0;
  double travel = 0, work = 0, taken = 0, lost = 0;
  std::vector<double> ends;
};


void
test(const CutBody<2> &body, const double friction, const double adhesion)
{
  SlidingBlade sliding;
  sliding.friction = friction;
  sliding.adhesion = adhesion;
  Columns columns(body, sliding);
  std::cout << "friction " << friction << ", adhesion " << adhesion
            << std::endl;
  double error = std::abs(columns.friction() / columns.area - columns.limit),
         imbalance  = 0;
  const double slip = columns.limit * width / shear_modulus;
  for (const double goal : {2., 1., .2, -1., -.2, 3., 2.5, 2.9, 1.6, -2., 4.})
    {
      columns.move_to(goal * slip);
      error = std::max(
        error, std::abs(columns.friction() / columns.area - columns.stress));
      imbalance = std::max(imbalance, std::abs(columns.imbalance()));
    }
  // Back from 2 slips it is free of stress at 1, and slips at 0.
  check_below("  begins to slip", std::abs(columns.ends.front() / slip), 1e-10);
  check_below("  shear stress", error / columns.limit, 1e-10);
  check_below("  energy", imbalance / columns.work, 1e-12);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    const Scene<2> scene(
      Parameters("test",
                 {{"Body", "Size", "1, 1", ""},
                  {"Body", "Elements", "2, 4", ""},
                  {"Support", "Fixed faces", "bottom", ""},
                  {"Blade", "Drive", "travel", ""},
                  {"Cut", "Surfaces", "x:1", ""},
                  {"Yield", "Criterion", "energy release", ""}},
                 Scene<2>::declare));
    CutBody<2> body(scene, MPI_COMM_WORLD);
    body.begin_cut(scene.cut.cuts[0]);
    body.split_nodes();
    for (unsigned int row = 0; row < body.seam().rows().size(); ++row)
      body.release_row(row);
    test(body, .3, 0.);
    test(body, .3, .01);
    test(body, 0., .02);
  });
}
