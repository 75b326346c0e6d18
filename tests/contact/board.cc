// SPDX-License-Identifier: LGPL-2.1-or-later
// A body on a board. A block that is pressed down on it is under uniform
// stress, whatever its elements, as on rollers: the foundation that carries it
// while its contacts are looked for leaves no trace. A half-space under a flat
// punch, which is a board below a part of it, has the pressure P / (pi sqrt(a^2
// - x^2)). Of a block that is pushed along the board it is said how much of
// Coulomb's coefficient times its weight holds it.

#include <setsudan/simulation/state.h>
#include <setsudan/simulation/state_on_board.h>

#include <algorithm>
#include <cmath>

#include "../test_setup.h"
#include "distorted_block.h"

using namespace Setsudan;
using namespace dealii;

constexpr double youngs_modulus = 5, poissons_ratio = 0.2, strain = 0.01;

using Values = std::vector<SceneEntry>;

/** A scene of the given values, and those that all have. */
template <int dim>
Scene<dim>
make_scene(Values values)
{
  values.insert(
    values.end(),
    {{"Material", "Young's modulus", std::to_string(youngs_modulus), ""},
     {"Material", "Poisson's ratio", std::to_string(poissons_ratio), ""},
     {"Material", "Formulation", "displacement", ""},
     {"Cut", "Surfaces", "", ""}});
  return Scene<dim>(Parameters("test", values, Scene<dim>::declare));
}



/** The block under uniform strain: on rollers or a board. */
template <int dim>
void
test_patch(const std::string &element_type)
{
  Values values = pressed_block<dim>(element_type, strain);
  values.insert(values.end(),
                {{"Support", "Fixed faces", "", ""},
                 {"Board", "Plane", dim == 3 ? "0,0,0; 0,1,0" : "0,0; 0,2", ""},
                 {"Board", "Friction", "0", ""}});
  const Scene<dim> scene = make_scene<dim>(values);
  CutBody<dim> body(scene, MPI_COMM_WORLD);
  const State<dim> state = state_on_board(body, rest_state(body));

  const double plane = dim == 2 ? 1 / (1 - poissons_ratio) : 1.;
  const double pressure =
    youngs_modulus * strain * plane / (dim == 2 ? 1 + poissons_ratio : 1.);
  double error      = 0;
  const auto &sites = body.model().discretization.dof_locations();
  for (unsigned int i = 0; i < sites.size(); ++i)
    {
      const auto &[position, c] = sites[i];
      const double expected =
        (c == 1 ? -1 : poissons_ratio * plane) * strain * position[c];
      error = std::max(error, std::abs(state.displacement(i) - expected));
    }
  const auto &corners = body.board()->corners();
  double uneven = std::abs(double(state.board->forces.size()) - corners.size());
  for (unsigned int i = 0; i < state.board->forces.size(); ++i)
    {
      auto force = state.board->forces[i].force;
      force[1] -= pressure * corners[i].hat.area;
      uneven = std::max(uneven, force.norm());
    }
  say(std::to_string(dim) + "D, " + element_type);
  check_below("  displacement", error / strain, 1e-9);
  check_below("  pressure at all corners", uneven / pressure, 1e-10);
  check_below("  force", std::abs(state.board->force / pressure - 1), 1e-10);
}



/** Half of a block of width and height 6 a under a punch of half-width a. */
void
test_punch()
{
  constexpr unsigned int n = 8;
  Scene<2> scene =
    make_scene<2>({{"Body", "Size", "48, 48", ""},
                   {"Body", "Elements", "48, 48", ""},
                   {"Support", "Fixed faces", "", ""},
                   {"Support", "Fixed components", "left : x", ""},
                   {"Support", "Displacements", "top : 0, -1", ""},
                   {"Board", "Plane", "0,0; 0,1", ""},
                   {"Board", "Friction", "0", ""}});
  const auto is_beside = [&](const CellFace &face) {
    return scene.body.mesh.cell_center(face.first)[0] > n;
  };
  // The scene is only read from here on.
  auto &faces = const_cast<std::vector<CellFace> &>(scene.board.faces);
  faces.erase(std::remove_if(faces.begin(), faces.end(), is_beside),
              faces.end());
  CutBody<2> body(scene, MPI_COMM_WORLD);
  const State<2> state = state_on_board(body, rest_state(body));
  auto forces          = state.board->forces;
  std::sort(forces.begin(), forces.end(), [](const auto &a, const auto &b) {
    return a.point[0] < b.point[0];
  });
  double sum = 0, error = 0, smallest = state.board->force;
  for (unsigned int i = 0; i < forces.size(); ++i)
    {
      // Up to a corner: half of its force.
      const double force = forces[i].force[1];
      const double x     = double(i) / n;
      const double part  = (sum + (i > 0) * force / 2) / state.board->force;
      sum += force;
      smallest = std::min(smallest, force);
      if (i < n)
        error =
          std::max(error, std::abs(part / 2 - std::asin(x) / numbers::PI));
    }
  say("punch, " + std::to_string(forces.size()) + " corners");
  check_below("  pull", -smallest, 0);
  check_below("  load up to x", error, 0.02);
}



/** What the board does to a block of which a side is moved by some distance. */
BoardLoad<2>
board_under_pushed_block(const double distance)
{
  const Scene<2> scene =
    make_scene<2>({{"Body", "Size", "4, 2", ""},
                   {"Body", "Elements", "8, 4", ""},
                   {"Load", "Body force", "0, -0.01", ""},
                   {"Support", "Fixed faces", "", ""},
                   {"Support",
                    "Displacements",
                    "left : " + std::to_string(distance) + ", free",
                    ""},
                   {"Board", "Plane", "0,0; 0,1", ""},
                   {"Board", "Friction", "0.5", ""}});
  CutBody<2> body(scene, MPI_COMM_WORLD);
  return *state_on_board(body, rest_state(body)).board;
}



void
test_friction()
{
  constexpr double weight = 0.08, limit = 0.5 * weight;
  say("block that is pushed aside");
  double before = 0;
  for (const double distance : {1e-3, 2e-3, 2e-2})
    {
      const auto board = board_under_pushed_block(distance);
      double friction  = 0;
      for (const auto &force : board.forces)
        friction -= force.force[0];
      check_below("  weight", std::abs(board.force - weight) / weight, 1e-8);
      check_below("  part of Coulomb's friction",
                  std::abs(board.part_of_friction - friction / limit),
                  1e-8);
      say(friction <= before ? "  FAILED"
          : friction < limit ? "  rises, and stays"
                             : "  rises, and would slide");
      before = friction;
    }
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for (const std::string type : {"linear", "serendipity", "quadratic"})
      {
        write_block<2>();
        test_patch<2>(type);
        write_block<3>();
        test_patch<3>(type);
      }
    test_punch();
    test_friction();
  });
}
