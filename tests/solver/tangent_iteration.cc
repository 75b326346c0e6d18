// SPDX-License-Identifier: LGPL-2.1-or-later
// Conjugate gradients with the tangent of a deformed body: how many they are
// with the factor and with the multigrid of the body at rest, that these are
// made anew where they do not serve, and that they see an unstable body.

#include <setsudan/parameters/exceptions.h>
#include <setsudan/solver/condensed/condensed_solver.h>
#include <setsudan/solver/newton_solver.h>
#include <setsudan/solver/tangent_iteration.h>

#include <cmath>
#include <memory>
#include <string>

#include "block.h"

using namespace Setsudan;
using namespace dealii;

/** Solve with the tangent to six digits, and say whether that takes no more
 * iterations than so many. */
void
test_iterations(const std::string &name,
                const Block &body,
                const LA::Vector &about,
                const bool has_factor,
                const unsigned int most)
{
  std::shared_ptr<CondensedSolver<3>> factor;
  if (has_factor)
    {
      factor = std::make_shared<CondensedSolver<3>>(
        body.model,
        body.constraints,
        IndexSet(body.model.discretization.dof_handler.n_dofs()));
      factor->set_constraints(body.constraints);
    }
  TangentIteration<3> iteration(
    body.model, *body.constraints, body.solver, factor);
  iteration.linearize({&about}, 1e-6);
  SolveQuality quality;
  const LA::Vector d = iteration.increment(
    body.model.loads, body.model.discretization.zero_vector(), quality);
  LA::Vector residual = tangent_times(body.model, about, d);
  residual -= body.model.loads;
  check_below_on_all("  residual",
                     condense(*body.constraints, residual).l2_norm() /
                       condense(*body.constraints, body.model.loads).l2_norm(),
                     1.1e-6);
  const unsigned int n = iteration.n_iterations();
  say(name +
      (n <= most ? ": at most " + std::to_string(most)
                 : ": FAILED, " + std::to_string(n)) +
      " iterations");
}


Assignments
pressed(const std::string &nu, const std::string &method)
{
  return {"Body/Size=10,10,10",
          "Body/Elements=4,4,4",
          "Support/Fixed faces=bottom",
          "Load/Tractions=top : 0.1, 0, -0.5",
          "Material/Young's modulus=5",
          "Material/Poisson's ratio=" + nu,
          "Deformation/Strain=finite",
          "Solver/Method=" + method};
}


void
test_pressed()
{
  const Block body(pressed("0.2", "iterative")),
    direct(pressed("0.2", "direct"));
  const Solution solution = body.solve();
  LA::Vector difference   = direct.solve().displacement;
  difference -= solution.displacement;
  check_below_on_all("iterative as direct",
                     difference.linfty_norm() /
                       solution.displacement.linfty_norm(),
                     1e-8);
  test_iterations("factor", body, solution.displacement, true, 25);
  test_iterations("multigrid", body, solution.displacement, false, 26);
}


/** The factor of a nearly incompressible body, whose tangent is assembled. */
void
test_mixed()
{
  const Block body(pressed("0.49", "direct"));
  test_iterations("mixed, factor", body, body.solve().displacement, true, 50);
}


/** Turned round, a body is nothing like the one at rest to a preconditioner. */
void
test_turned()
{
  const Block body(pressed("0.3", "iterative"));
  const LA::Vector turned =
    nodal_values(body.model.discretization, [](const Point<3> &p) {
      return Tensor<1, 3>({-p[1] - p[0], p[0] - p[1], 0.});
    });
  test_iterations("turned", body, turned, false, 90);
  test_iterations("turned, factor", body, turned, true, 50);
}


/** A column under ten times the load at which it buckles, which is symmetric;
 * so is the load. */
void
test_unstable()
{
  const Block body({"Body/Size=1,1,20",
                    "Body/Elements=1,1,10",
                    "Support/Fixed faces=bottom",
                    "Load/Tractions=top : 0, 0, -0.0257",
                    "Material/Poisson's ratio=0",
                    "Deformation/Strain=finite",
                    "Solver/Method=iterative"});
  try
    {
      body.solve();
      say("FAILED: a state that is not stable was taken");
    }
  catch (const NoEquilibriumError &)
    {
      say("column: buckles");
    }
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_pressed();
    test_mixed();
    test_turned();
    test_unstable();
  });
}
