// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/solver_parameters.h>

namespace Setsudan
{
using namespace dealii;

void
SolverParameters::declare(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Solver",
                    "Method",
                    "auto",
                    Patterns::Selection("auto|direct|iterative"),
                    "direct: sparse Cholesky; iterative: conjugate gradients "
                    "with multigrid, and without a matrix where elements are "
                    "not linear; auto: by the number of unknowns.");
  Setsudan::declare(handler,
                    "Solver",
                    "Direct up to",
                    "20000",
                    Patterns::Integer(0),
                    "With auto, bodies of at most so many unknowns are solved "
                    "directly [-].");
  Setsudan::declare(handler,
                    "Solver",
                    "Tolerance",
                    "1e-10",
                    Patterns::Double(),
                    "Residual at which the iteration ends, relative to the "
                    "forces; greater than 0 and at most 1e-3 [-].");
  Setsudan::declare(handler,
                    "Solver",
                    "Maximum iterations",
                    "2000",
                    Patterns::Integer(1),
                    "An iteration that takes more has failed [-].");
  Setsudan::declare(handler,
                    "Division",
                    "Solve",
                    "auto",
                    Patterns::Selection("auto|condensed|every row anew"),
                    "How the states of a cut are solved. condensed: the body "
                    "is factored once for all rows and condensed onto the cut, "
                    "which is exact, and takes memory for all unknowns of the "
                    "cut; every row anew: by Solver/Method, row by row; auto: "
                    "by the sizes. Several processes solve every row anew. "
                    "Where contact is found (Blade/Drive = travel, or wedged) "
                    "auto condenses what can be factored, on any number of "
                    "processes; every row anew then takes a solve for each "
                    "force of contact in each row.");
}



SolverParameters::SolverParameters(const Parameters &parameters)
  : direct_up_to(parameters.natural("Solver", "Direct up to"))
  , tolerance(parameters.number("Solver", "Tolerance"))
  , max_iterations(parameters.natural("Solver", "Maximum iterations"))
{
  const std::string cut  = parameters.text("Division", "Solve");
  cut_solve              = cut == "condensed"        ? CutSolve::condensed
                           : cut == "every row anew" ? CutSolve::row_by_row
                                                     : CutSolve::automatic;
  const std::string name = parameters.text("Solver", "Method");
  method                 = name == "direct"      ? Method::direct
                           : name == "iterative" ? Method::iterative
                                                 : Method::automatic;
  parameters.require(tolerance > 0 && tolerance <= 1e-3,
                     "Solver",
                     "Tolerance",
                     "a number greater than 0 and at most 1e-3");
}



bool
SolverParameters::is_direct(const types::global_dof_index n_unknowns) const
{
  return method == Method::direct ||
         (method == Method::automatic && n_unknowns <= direct_up_to);
}
} // namespace Setsudan
