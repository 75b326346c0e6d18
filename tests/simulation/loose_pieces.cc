// A horizontal cut leaves the top piece without support: it is held where that
// strains nothing, and refused where a load or the next cut would push it.

#include <setsudan/simulation/state.h>

#include "../test_setup.h"

using namespace Setsudan;

void
divide(const std::string &body_force, const bool cut_again)
{
  const Parameters parameters("test",
                              {{"Body", "Elements", "2,2,2", ""},
                               {"Support", "Fixed faces", "bottom", ""},
                               {"Blade", "Direction", "-1,0,0", ""},
                               {"Load", "Body force", body_force, ""},
                               {"Cut", "Surfaces", "z:1; y:1", ""}},
                              Scene<3>::declare);
  const Scene<3> scene(parameters);
  CutBody<3> body(scene, MPI_COMM_WORLD);
  std::cout << "body force '" << body_force << "': " << std::endl;
  try
    {
      body.approach(make_cut_surface(scene.body, scene.cut.surfaces[0]));
      body.open();
      body.divide();
      for (const auto &loose : body.loose_pieces)
        std::cout << "  piece " << loose.piece << " of " << body.n_pieces()
                  << " is held at " << loose.hold.size() << " components"
                  << std::endl;
      const auto &discretization = body.model->discretization;
      const auto state           = solve_state(
        scene, body, no_blade(body), 0, discretization.zero_vector());
      check_below("  displacement", state.displacement.linfty_norm(), 1e-14);
      if (cut_again)
        body.approach(make_cut_surface(scene.body, scene.cut.surfaces[1]));
    }
  catch (const std::runtime_error &error)
    {
      // Behind the bracket stand residuals, of which one is round-off.
      const std::string message = error.what();
      std::cout << "  " << message.substr(0, message.find(" (")) << std::endl;
    }
}

int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    divide("", false);
    divide("0, 0, -1", false);
    divide("", true);
  });
}
