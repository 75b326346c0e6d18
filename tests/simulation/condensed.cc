// SPDX-License-Identifier: LGPL-2.1-or-later
// The states of a cut from one factorization are those of solving every row
// anew: of tied, opened and free rows, of oblique cuts and crossing ones, with
// hanging nodes, and of several kinds of elements; also where rows are tied
// again.

#include <setsudan/simulation/state.h>
#include <setsudan/solver/assembled_solver.h>
#include <setsudan/solver/condensed/condensed_solver.h>

#include <cmath>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

/** How far the state under the blade is from that solved anew. */
template <int dim>
double
difference(CutBody<dim> &body, const BladeLoad<dim> &blade)
{
  const auto &model      = body.model();
  const LA::Vector zero  = model.discretization.zero_vector();
  const State<dim> state = solve_state(body, blade, 1, zero);
  const auto constraints = body.constraints();
  LA::Vector anew =
    AssembledSolver<dim>(
      model, constraints, body.scene().solver, SolverKind::cholesky)
      .solve(state.forces, lift_of(body, state), zero)
      .displacement;
  anew -= state.displacement;
  return anew.linfty_norm() / state.displacement.linfty_norm();
}


template <int dim>
void
test_solve(const std::string &name,
           const std::string &criterion,
           const std::vector<SceneEntry> &more,
           const bool looks_ahead)
{
  std::vector<SceneEntry> entries = {
    {"Body", "Elements", dim == 3 ? "2,2,2" : "4,4", ""},
    {"Support", "Fixed faces", "bottom", ""},
    {"Support", "Loose pieces", "drop", ""},
    {"Blade", "Edge loads", dim == 3 ? "1:1, 4:2" : "0:1", ""},
    {"Load", "Body force", dim == 3 ? "0.01, 0.02, -0.1" : "0.1, -0.1", ""},
    {"Division", "Solve", "condensed", ""},
    {"Yield", "Criterion", criterion, ""},
    {"Cut", "Surfaces", dim == 3 ? "y:1" : "x:2", ""}};
  entries.insert(entries.end(), more.begin(), more.end());
  const Scene<dim> scene(Parameters("test", entries, Scene<dim>::declare));
  CutBody<dim> body(scene, MPI_COMM_WORLD);
  double largest    = 0;
  bool is_condensed = true;
  for (const auto &cut : scene.cut.cuts)
    {
      if (!body.begin_cut(cut))
        continue;
      body.split_nodes();
      for (unsigned int row = 0; row < body.seam().rows().size(); ++row)
        {
          if (body.is_left_out(row))
            continue;
          const auto blade = body.blade_on_row(row);
          largest          = std::max(largest, difference(body, blade));
          // To look at the state without this row leaves no trace.
          const auto without =
            looks_ahead ? body.solver_without(row) : body.solver();
          is_condensed =
            is_condensed && dynamic_cast<CondensedSolver<dim> *>(without.get());
          largest = std::max(largest, difference(body, blade));
          body.release_row(row);
        }
      body.finish_cut();
      largest = std::max(largest, difference(body, no_blade(body.model())));
    }
  std::cout << name << (is_condensed ? "" : ": it is not") << std::endl;
  check_below("  difference", largest, 1e-10);
}


/** The dense factor grows as rows split where the criterion looks at states
 * beside those of the cut; elsewhere it is made at once. */
template <int dim>
void
test(const std::string &name,
     const std::vector<SceneEntry> &more,
     const bool looks_ahead = true)
{
  test_solve<dim>(name + ", growing", "energy release", more, looks_ahead);
  test_solve<dim>(name + ", at once", "maximum shear", more, false);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test<2>("2D", {});
    test<3>("3D", {});
    test<3>("by element rows", {{"Division", "Release", "element row", ""}});
    test<3>("free rows", {{"Division", "Split rows", "free", ""}});
    test<2>("refined near the cut", {{"Cut", "Refinement near cut", "1", ""}});
    test<2>("oblique",
            {{"Body", "Rotate", "z : 30", ""},
             {"Cut", "Surfaces", "x:2", ""},
             {"Blade", "Direction", "0.5, -0.9", ""},
             {"Blade", "Edge loads", "", ""}});
    test<3>("crossing",
            {{"Cut", "Surfaces", "y:1; z:1", ""},
             {"Blade", "Direction", "0,0,-1; 0,-1,0", ""}},
            false);
    test<3>("quadratic elements", {{"Body", "Element type", "quadratic", ""}});
    test<3>("nearly incompressible",
            {{"Material", "Poisson's ratio", "0.4999", ""}});
  });
}
