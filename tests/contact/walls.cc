// SPDX-License-Identifier: LGPL-2.1-or-later
// A block that is cut through and pressed together across the cut is under the
// same uniform stress as if it were not cut: contact passes this patch test on
// the faces of all elements, in distorted meshes. So it is with a blade of some
// thickness between the halves of one that is not pressed, be it one that
// travels, whose flanks meet a wall each, or one that keeps the walls apart.

#include <setsudan/simulation/cut_contact.h>
#include <setsudan/simulation/state.h>

#include <algorithm>
#include <cmath>

#include "../test_setup.h"
#include "distorted_block.h"

using namespace Setsudan;
using namespace dealii;

constexpr double youngs_modulus = 5, poissons_ratio = 0.2, strain = 0.01;

enum class Between
{
  nothing,
  flanks,
  thickness
};

template <int dim>
void
test(const std::string &element_type, const Between between)
{
  const bool has_blade = between != Between::nothing;
  const bool travels   = between != Between::thickness;
  auto values = pressed_block<dim>(element_type, has_blade ? 0. : strain);
  values.insert(
    values.end(),
    {{"Material", "Young's modulus", std::to_string(youngs_modulus), ""},
     {"Material", "Poisson's ratio", std::to_string(poissons_ratio), ""},
     {"Material", "Formulation", "displacement", ""},
     {"Support", "Fixed components", "start : y", ""},
     {"Blade", "Drive", travels ? "travel" : "force", ""},
     {"Blade", "Thickness", std::to_string(strain), ""},
     {"Division", "Split rows", travels ? "opened" : "wedged", ""},
     {"Blade", "Direction", dim == 3 ? "0,0,-1" : "1,0", ""},
     {"Cut", "Surfaces", "where : y - 0.5", ""},
     {"Yield", "Criterion", "energy release", ""}});
  const Scene<dim> scene(Parameters("test", values, Scene<dim>::declare));
  CutBody<dim> body(scene, MPI_COMM_WORLD);
  body.begin_cut(scene.cut.cuts[0]);
  body.split_nodes();
  const unsigned int n_rows = body.seam().rows().size();
  for (unsigned int row = 0; row < n_rows; ++row)
    body.release_row(row);

  BladeProfile profile;
  if (between == Between::thickness)
    profile.keeps_apart = strain;
  if (between == Between::flanks)
    profile.facets = {{-10., strain / 2, 0.}};
  const LA::Vector at_rest = body.model().discretization.zero_vector();
  CutContact<dim> contact(body, profile, at_rest);
  const auto path        = contact.path(n_rows, 0, BladeMotion(), nullptr);
  const State<dim> state = contact.state(*path, n_rows, 0, at_rest);

  // Strained along y, and widened freely across it.
  const double plane = dim == 2 ? 1 / (1 - poissons_ratio) : 1.;
  double error       = 0;
  const auto &sites  = body.model().discretization.dof_locations();
  for (unsigned int i = 0; i < sites.size(); ++i)
    {
      const auto &[position, c] = sites[i];
      if (c != 1)
        error =
          std::max(error,
                   std::abs(state.displacement(i) -
                            poissons_ratio * plane * strain * position[c]));
    }
  check_below(std::to_string(dim) + "D, " + element_type +
                (between == Between::flanks ? ", blade between the walls"
                 : has_blade                ? ", blade that keeps walls apart"
                                            : ", wall on wall"),
              error / strain,
              1e-10);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for (const auto between :
         {Between::nothing, Between::flanks, Between::thickness})
      for (const std::string type : {"linear", "serendipity", "quadratic"})
        {
          write_block<2>();
          test<2>(type, between);
          write_block<3>();
          test<3>(type, between);
        }
  });
}
