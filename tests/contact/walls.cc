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
#include <fstream>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

constexpr double youngs_modulus = 5, poissons_ratio = 0.2, strain = 0.01;

/** 2 elements along each axis of the unit cube or square; the nodes in its
 * middle are moved, those on the cut y = 1/2 in their plane. */
template <int dim>
void
write_block()
{
  constexpr unsigned int n_nodes = dim == 3 ? 27 : 9,
                         n_cells = dim == 3 ? 8 : 4, n_ends = 2 * (dim - 1);
  std::ofstream out("block.msh");
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
      << "$PhysicalNames\n2\n"
      << dim - 1 << " 1 \"start\"\n"
      << dim - 1 << " 2 \"end\"\n$EndPhysicalNames\n"
      << "$Nodes\n"
      << n_nodes << "\n";
  for (unsigned int i = 0; i < n_nodes; ++i)
    {
      const std::array<unsigned int, 3> at{{i % 3, i / 3 % 3, i / 9}};
      out << i + 1;
      for (unsigned int d = 0; d < 3; ++d)
        out << " "
            << at[d] / 2. + (at[d] == 1 && d != 1
                               ? 0.12 * std::sin(3. * i + 2. * d + 1)
                               : 0.);
      out << "\n";
    }
  out << "$EndNodes\n$Elements\n" << n_cells + 2 * n_ends << "\n";
  unsigned int number = 1;
  for (const unsigned int end : {0, 1})
    for (unsigned int f = 0; f < n_ends; ++f)
      {
        const unsigned int first = 1 + 6 * end + f % 2 + 9 * (f / 2);
        out << number++ << (dim == 3 ? " 3 2 " : " 1 2 ") << end + 1 << " 1 "
            << first << " " << first + 1;
        if (dim == 3)
          out << " " << first + 10 << " " << first + 9;
        out << "\n";
      }
  for (unsigned int e = 0; e < n_cells; ++e)
    {
      const unsigned int first = 1 + e % 2 + 3 * (e / 2 % 2) + 9 * (e / 4);
      out << number++ << (dim == 3 ? " 5 2 3 1" : " 3 2 3 1");
      for (unsigned int layer = 0; layer < dim - 1; ++layer)
        for (const unsigned int corner : {0, 1, 4, 3})
          out << " " << first + corner + 9 * layer;
      out << "\n";
    }
  out << "$EndElements\n";
}



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
  const bool has_blade   = between != Between::nothing;
  const bool travels     = between != Between::thickness;
  const std::string free = dim == 3 ? ", free" : "";
  const Scene<dim> scene(Parameters(
    "test",
    {{"Body", "Shape", "file", ""},
     {"Body", "File", "block.msh", ""},
     {"Body", "Element type", element_type, ""},
     {"Material", "Young's modulus", std::to_string(youngs_modulus), ""},
     {"Material", "Poisson's ratio", std::to_string(poissons_ratio), ""},
     {"Material", "Formulation", "displacement", ""},
     {"Support", "Fixed components", "start : y", ""},
     {"Support",
      "Fixed boxes",
      dim == 3 ? "-9,-9,-9,0,9,9 : x; -9,-9,-9,9,9,0 : z" : "-9,-9,0,9 : x",
      ""},
     {"Support",
      "Displacements",
      "end : free, -" + std::to_string(has_blade ? 0. : strain) + free,
      ""},
     {"Blade", "Drive", travels ? "travel" : "force", ""},
     {"Blade", "Thickness", std::to_string(strain), ""},
     {"Division", "Split rows", travels ? "opened" : "wedged", ""},
     {"Blade", "Direction", dim == 3 ? "0,0,-1" : "1,0", ""},
     {"Cut", "Surfaces", "where : y - 0.5", ""},
     {"Yield", "Criterion", "energy release", ""}},
    Scene<dim>::declare));
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
