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


void
test_choice()
{
  for (const std::string method : {"auto", "direct", "iterative"})
    {
      const SolverParameters parameters(
        parameters_of({"Solver/Method=" + method, "Solver/Direct up to=20000"},
                      SolverParameters::declare));
      for (const unsigned int n : {1, 1500, 1501, 20000, 20001})
        {
          const auto solver = make_linear_solver(parameters, n, MPI_COMM_WORLD);
          std::cout << method << ", " << n
                    << " unknowns: " << solver->description()
                    << (solver->is_iterative() ? ", iterates" : "")
                    << std::endl;
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
