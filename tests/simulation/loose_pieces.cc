// SPDX-License-Identifier: LGPL-2.1-or-later
// A horizontal cut leaves the top piece without support: it is held where that
// strains nothing, and refused where a load or the next cut would push it; or
// it is dropped, if that is wanted.

#include <setsudan/simulation/state.h>

#include "../test_setup.h"

using namespace Setsudan;

void
divide(const std::string &body_force,
       const bool cut_again,
       const std::string &top_held_in = "")
{
  const Parameters parameters(
    "test",
    {{"Body", "Elements", "2,2,2", ""},
     {"Support", "Fixed faces", "bottom", ""},
     {"Support",
      "Fixed components",
      top_held_in.empty() ? "" : "top : " + top_held_in,
      ""},
     {"Blade", "Direction", "-1,0,0", ""},
     {"Load", "Body force", body_force, ""},
     {"Cut", "Surfaces", "z:1; y:1", ""}},
    Scene<3>::declare);
  const Scene<3> scene(parameters);
  CutBody<3> body(scene, MPI_COMM_WORLD);
  std::cout << "body force '" << body_force << "', top held in '" << top_held_in
            << "': " << std::endl;
  try
    {
      body.begin_cut(scene.cut.cuts[0]);
      body.split_nodes();
      body.finish_cut();
      for (const auto &loose : body.floating_pieces())
        std::cout << "  piece " << loose.piece << " of " << body.n_pieces()
                  << " is held at " << loose.hold.size() << " components"
                  << std::endl;
      const auto &discretization = body.model().discretization;
      const auto state           = solve_state(
        body, no_blade(body.model()), 0, discretization.zero_vector());
      if (body_force.empty())
        check_below("  displacement", state.displacement.linfty_norm(), 1e-14);
      else
        {
          LA::Vector held = state.internal;
          held -= state.forces;
          double strain = 0;
          for (const auto index : unknowns_of_hold(discretization,
                                                   body.mesh(),
                                                   body.labels().piece,
                                                   body.floating_pieces()))
            strain = std::max(strain, std::abs(held(index)));
          check_below("  forces that hold it", strain, 1e-12);
        }
      if (cut_again)
        body.begin_cut(scene.cut.cuts[1]);
    }
  catch (const std::runtime_error &error)
    {
      // Behind the bracket stand residuals, of which one is round-off.
      const std::string message = error.what();
      std::cout << "  " << message.substr(0, message.find(" (")) << std::endl;
    }
}

/** The body of which the dropped piece is no part any more: 2 x 2 x 1 elements
 * below, under their own weight, and where they are held they are not moved. */
Scene<3>
lower_half()
{
  return Scene<3>(Parameters("test",
                             {{"Body", "Elements", "2,2,1", ""},
                              {"Body", "Size", "10,10,5", ""},
                              {"Support", "Fixed faces", "bottom", ""},
                              {"Load", "Body force", "0, 0, -1", ""}},
                             Scene<3>::declare));
}

/** Drop the upper half, which a clamp moves in one direction, with its weight
 * and a pressure on it. */
void
drop()
{
  std::cout << "dropped:" << std::endl;
  const Parameters parameters(
    "test",
    {{"Body", "Elements", "2,2,2", ""},
     {"Support", "Fixed faces", "bottom", ""},
     {"Support", "Displacements", "top : 0.1, free, free", ""},
     {"Support", "Loose pieces", "drop", ""},
     {"Load", "Body force", "0, 0, -1", ""},
     {"Load", "Pressures", "top : 3", ""},
     {"Cut", "Surfaces", "z:1; y:1; x:1", ""},
     {"Blade", "Direction", "-1,0,0; -1,0,0; 0,-1,0", ""},
     {"Cut", "Extent", "all; all; box: 0, 0, 5, 10, 10, 10", ""}},
    Scene<3>::declare);
  const Scene<3> scene(parameters);
  CutBody<3> body(scene, MPI_COMM_WORLD);
  body.begin_cut(scene.cut.cuts[0]);
  body.split_nodes();
  body.finish_cut();
  const auto solve = [](CutBody<3> &body) {
    return solve_state(body,
                       no_blade(body.model()),
                       0,
                       body.model().discretization.zero_vector());
  };
  const auto state  = solve(body);
  const auto &below = lower_half();
  CutBody<3> body_below(below, MPI_COMM_WORLD);
  const auto state_below = solve(body_below);

  const auto &discretization = body.model().discretization;
  const auto u               = discretization.with_ghosts(state.displacement);
  double largest[]           = {0, 0};
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    for (const auto &node : discretization.node_indices(cell))
      for (const auto index : node)
        {
          double &of_half = largest[discretization.element(cell) < 4 ? 0 : 1];
          of_half         = std::max(of_half, std::abs(u(index)));
        }
  check_below("  displacement of what is dropped", largest[1], 0.);
  check_below("  the rest moves alone",
              std::abs(largest[0] - state_below.displacement.linfty_norm()),
              1e-12 * largest[0]);

  // The next cut goes through both halves, the last only through the upper.
  const bool goes_on = body.begin_cut(scene.cut.cuts[1]);
  std::cout << "  the next cut " << (goes_on ? "goes" : "does not go") << " on";
  unsigned int highest = 0;
  for (const auto &pair : body.seam().pairs())
    highest = std::max(highest, static_cast<unsigned int>(pair.position[2]));
  std::cout << ", up to height " << highest << std::endl;
  body.split_nodes();
  body.finish_cut();
  std::cout << "  " << body.n_pieces() << " pieces, the last cut "
            << (body.begin_cut(scene.cut.cuts[2]) ? "goes" : "does not go")
            << " on" << std::endl;
}

int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    divide("", false);
    divide("0, 0, -1", false);
    divide("", true);
    // What the supports carry need not be in equilibrium.
    divide("0, 0, -1", false, "z");
    divide("0, 1, -1", false, "z");
    divide("0, 1, -1", false, "yz");
    drop();
  });
}
