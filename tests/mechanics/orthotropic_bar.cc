// SPDX-License-Identifier: LGPL-2.1-or-later
// A bar that is pulled at an angle to the axes of its orthotropic material: it
// stretches by the modulus in that direction (closed form, Sitka spruce) and
// shears. On distorted elements a linear displacement is in equilibrium and has
// its energy, in the plane too; and the matrices are those of the law's stress.

#include <setsudan/mechanics/strain_and_stress.h>

#include <deal.II/dofs/dof_tools.h>

#include <cmath>

#include "../test_setup.h"
#include "solved_model.h"

using namespace Setsudan;
using namespace dealii;

/** Axes that are turned about z by the first angle, and about y by the second.
 */
std::string
axes(const double about_z, const double about_y)
{
  const double c = std::cos(about_z), s = std::sin(about_z);
  const double C = std::cos(about_y), S = std::sin(about_y);
  std::string text;
  for (const double x : {c * C, s, -c * S, -s * C, c, s * S})
    text += (text.empty() ? "" : ", ") + short_text(x);
  return text;
}


Assignments
spruce(const double about_z, const double about_y)
{
  return {"Material/Young's moduli=9050, 403, 403",
          "Material/Poisson's ratios=0.467, 0.3, " +
            short_text(0.467 * 403 / 9050),
          "Material/Shear moduli=1095, 80, 1095",
          "Material/Axes=" + axes(about_z, about_y)};
}


/** @param degrees between the bar and the fibres. */
void
test_bar(const double degrees, const bool in_plane)
{
  const double angle       = degrees * numbers::PI / 180;
  Assignments assignments  = in_plane ? spruce(angle, 0) : spruce(0, angle);
  const Assignments others = {"Body/Size=8, 2, 3",
                              "Body/Elements=2, 1, 1",
                              "Support/Fixed components=left : x",
                              "Support/Fixed boxes=0, 0, 0, 0, 0, 0 : yz; "
                              "0, 2, 0, 0, 2, 0 : z",
                              "Load/Tractions=right : 40.3, 0, 0"};
  assignments.insert(assignments.end(), others.begin(), others.end());
  const SolvedModel<3> solved(assignments);
  const double c = std::cos(angle), s = std::sin(angle);
  const double across = 1 / 1095. - 2 * 0.467 / 9050;
  const double inverse =
    std::pow(c, 4) / 9050 + std::pow(s, 4) / 403 + s * s * c * c * across;
  // The coefficient S16 of the shear, which is S15 where the fibres leave the
  // plane.
  const double coupling =
    2 * s * c * (c * c / 9050 - s * s / 403) - s * c * (c * c - s * s) * across;
  double of_stretch = 0, of_shear = 0;
  const auto &discretization = solved.model.discretization;
  const LA::Vector u         = discretization.with_ghosts(solved.displacement);
  const unsigned int side    = in_plane ? 1 : 2;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    {
      const auto nodes     = discretization.node_indices(cell);
      const auto positions = discretization.node_positions(cell);
      for (unsigned int node = 0; node < nodes.size(); ++node)
        {
          const double x = positions[node][0];
          of_stretch     = std::max(
            of_stretch, std::abs(u(nodes[node][0]) - 40.3 * inverse * x));
          // Along the lines from the nodes that do not move sideways.
          if (positions[node][1] == 0 && positions[node][2] == 0)
            of_shear =
              std::max(of_shear,
                       std::abs(u(nodes[node][side]) -
                                (in_plane ? 1 : -1) * 40.3 * coupling * x));
        }
    }
  std::cout << "pulled at " << degrees << " degrees in the plane "
            << (in_plane ? "xy" : "xz") << ", modulus " << 1 / inverse
            << std::endl;
  check_below("  stretch", of_stretch / (40.3 * inverse * 8), 1e-10);
  check_below("  shear", of_shear / (40.3 * inverse * 8), 1e-10);
}


/** On distorted elements. */
template <int dim>
void
test_patch(const Assignments &material)
{
  Assignments assignments = material;
  assignments.push_back(dim == 3 ? "Body/Elements=2, 2, 3"
                                 : "Body/Elements=3, 3");
  const SmallModel<dim> box(assignments);
  const auto mesh = distorted(box.body.mesh);
  const SmallModel<dim> small(assignments, &mesh);
  const auto &discretization = small.model.discretization;
  Tensor<2, dim> gradient;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = 0; j < dim; ++j)
      gradient[i][j] = 0.1 * std::sin(1 + 3 * i + 7 * j);
  const LA::Vector u =
    nodal_values(discretization, [&](const Point<dim> &point) {
      return Point<dim>(gradient * point);
    });
  const LA::Vector forces = internal_forces(small.model, u);

  double volume = 0;
  for (unsigned int element = 0; element < mesh.cells.size(); ++element)
    volume += volume_of_element(mesh.node_positions(element));
  const auto &law = *small.material.of_element(0).law;
  const double energy =
    law.evaluate(in_space(gradient), {}, false).energy.stored * volume;
  const IndexSet outside =
    DoFTools::extract_boundary_dofs(discretization.dof_handler);
  double inside = 0;
  for (const auto index : discretization.owned)
    if (!outside.is_element(index))
      inside = std::max(inside, std::abs(forces(index)));
  std::cout << "patch in " << dim << "D" << std::endl;
  check_below("  forces inside", inside / forces.linfty_norm(), 1e-12);
  check_below("  energy", std::abs(forces * u / (2 * energy) - 1), 1e-12);

  // Point by point, of a displacement that is not linear.
  const LA::Vector curved =
    nodal_values(discretization, [](const Point<dim> &point) {
      Point<dim> value;
      for (unsigned int d = 0; d < dim; ++d)
        value[d] = std::sin(point[d] + 0.3 * point[(d + 1) % dim]);
      return value;
    });
  const LA::Vector by_matrices = internal_forces(small.model, curved);
  const auto by_law            = evaluate_laws(small.model, curved);
  LA::Vector difference        = by_law.forces;
  difference -= by_matrices;
  check_below("  matrices and the law's stress",
              difference.linfty_norm() / by_matrices.linfty_norm(),
              1e-12);
  check_below("  their energies",
              std::abs(by_matrices * curved / (2 * by_law.energy.stored) - 1),
              1e-12);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for (const double degrees : {0, 10, 30, 45, 90})
      test_bar(degrees, true);
    test_bar(30, false);
    test_patch<3>(spruce(0.4, 0.7));
    test_patch<2>(spruce(0.4, 0));
  });
}
