// SPDX-License-Identifier: LGPL-2.1-or-later
// What a solver says that did not solve: an iteration that is not allowed to
// take long enough, and bodies that nothing holds.

#include <setsudan/solver/linear/linear_solver.h>

#include <string>

#include "../mechanics/solved_model.h"
#include "../test_setup.h"

using namespace Setsudan;

/** The message of a solve, with what may differ by round-off left out: the
 * number behind `before`. */
void
print_failure(const Assignments &assignments, const std::string &before)
{
  try
    {
      SolvedModel<3> solved(assignments);
      std::cout << "FAILED: solved" << std::endl;
    }
  catch (const SolverError &error)
    {
      std::string message = error.what();
      const auto begin    = message.find(before);
      if (begin != std::string::npos)
        {
          const auto number = begin + before.size();
          const auto end    = message.find_first_of(" ,", number);
          message.replace(number, end - number, "(number)");
        }
      std::cout << message << std::endl;
    }
}


/** Nothing holds the body, and its load is in no equilibrium. */
void
test_loose_body(const std::string &n_elements, const std::string &method)
{
  try
    {
      SolvedModel<3> solved({"Body/Elements=" + n_elements,
                             "Load/Body force=0, 0, -1",
                             "Solver/Method=" + method,
                             "Solver/Maximum iterations=50"});
      std::cout << "FAILED: solved" << std::endl;
    }
  catch (const SolverError &error)
    {
      std::cout << "a loose body, " << method << ": refused" << std::endl;
    }
}


/** What is chosen for a body, and for a cut of it. */
void
test_choice()
{
  for (const std::string method : {"auto", "direct", "iterative"})
    {
      const SolverParameters parameters(
        parameters_of({"Solver/Method=" + method, "Solver/Direct up to=20000"},
                      SolverParameters::declare));
      for (const unsigned int n : {1, 20000, 20001})
        for (const auto type : {ElementType::serendipity, ElementType::linear})
          for (const unsigned int n_processes : {1, 2})
            {
              const auto choice =
                choose_solver(parameters, {n, type, n_processes});
              std::cout << method << ", " << n << " unknowns, "
                        << (type == ElementType::linear ? "linear, " : "")
                        << n_processes
                        << " processes: " << description(choice.kind) << ", "
                        << choice.reason << std::endl;
            }
    }
  for (const std::string solve : {"auto", "condensed", "every row anew"})
    {
      const SolverParameters parameters(
        parameters_of({"Division/Solve=" + solve}, SolverParameters::declare));
      for (const SystemSize size :
           {SystemSize{10000, ElementType::serendipity, 1},
            SystemSize{10000, ElementType::serendipity, 2},
            SystemSize{300000, ElementType::serendipity, 1},
            SystemSize{500000, ElementType::serendipity, 2}})
        for (const CutSize cut : {CutSize{},
                                  CutSize{2, 100},
                                  CutSize{20, 1000},
                                  CutSize{20, 1000, true},
                                  CutSize{20, 1000, true, true},
                                  CutSize{20, 50000}})
          {
            const auto choice = choose_cut_strategy(parameters, size, cut);
            std::cout << solve << ", " << size.n_unknowns << " unknowns, "
                      << size.n_processes << " processes, " << cut.n_rows
                      << " rows of " << cut.n_interface_unknowns
                      << (cut.has_foundation ? ", on a board"
                          : cut.has_contact  ? ", with contact"
                                             : "")
                      << ": "
                      << (choice.kind == CutStrategy::condensed ? "condensed"
                                                                : "row by row")
                      << ", " << choice.reason << std::endl;
          }
    }
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    print_failure({"Body/Elements=6, 4, 4",
                   "Support/Fixed faces=left",
                   "Load/Body force=0, 0, -1",
                   "Solver/Method=iterative",
                   "Solver/Maximum iterations=1"},
                  "relative residual of ");
    test_loose_body("2, 2, 2", "direct");
    test_loose_body("6, 4, 4", "direct");
    test_loose_body("6, 4, 4", "iterative");
    test_choice();
  });
}
