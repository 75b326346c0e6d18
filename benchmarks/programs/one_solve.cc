// One solve of a block of N^3 elements that stands on its bottom and is loaded
// on its top: one_solve METHOD N [distorted] [ASSIGNMENT...]. METHOD is
// multigrid (over the order of the functions, without a matrix), algebraic
// (multigrid of the assembled matrix) or direct; assignments as the command
// line of the program has them. Prints a line: unknowns, iterations, seconds
// for the set-up and for the solve, relative residual, peak memory in MB.

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <setsudan/solver/equilibrium.h>
#include <setsudan/solver/multigrid_equilibrium.h>

#include <sys/resource.h>

#include <iostream>
#include <string>

#include "../../tests/elasticity/small_model.h"

using namespace Setsudan;
using namespace dealii;

namespace
{
constexpr int dim = 3;

struct Problem : SmallModel<dim>
{
  static void
  declare(ParameterHandler &handler)
  {
    SmallModel<dim>::declare(handler);
    SolverParameters::declare(handler);
  }

  Problem(const Parameters &parameters, const CoarseMesh<dim> *mesh)
    : SmallModel<dim>(parameters, mesh)
    , solver(parameters)
  {
  }

  const SolverParameters solver;
};


double
peak_memory()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024.;
}


void
measure(const std::string &method, Problem &problem)
{
  auto &model           = problem.model;
  const LA::Vector zero = model.discretization.zero_vector();
  Timer timer;
  std::unique_ptr<EquilibriumSolver> equilibrium;
  if (method == "multigrid")
    equilibrium = std::make_unique<MultigridEquilibrium<dim>>(
      model, model.supports, problem.solver);
  else
    equilibrium =
      std::make_unique<Equilibrium<dim>>(model, model.supports, problem.solver);
  const double set_up = timer.wall_time();
  timer.restart();
  equilibrium->solve(model.loads, model.prescribed, zero);
  const double solve        = timer.wall_time();
  unsigned int n_iterations = 0;
  if (method == "multigrid")
    n_iterations =
      static_cast<MultigridEquilibrium<dim> &>(*equilibrium).n_iterations();
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << model.discretization.dof_handler.n_dofs() << " "
              << n_iterations << " " << set_up << " " << solve << " "
              << equilibrium->quality_of_last().residual << " " << peak_memory()
              << std::endl;
}
} // namespace


int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (argc < 3)
    {
      std::cerr << "usage: one_solve METHOD N [distorted] [ASSIGNMENT...]\n";
      return 1;
    }
  const std::string method(argv[1]), n(argv[2]);
  Assignments assignments{"Body/Elements=" + n + "," + n + "," + n,
                          "Support/Fixed faces=bottom",
                          "Load/Tractions=top: 0.3, 0.1, -1",
                          "Material/Poisson's ratio=0.2",
                          "Solver/Tolerance=1e-8",
                          std::string("Solver/Method=") +
                            (method == "direct" ? "direct" : "iterative")};
  bool is_distorted = false;
  for (int i = 3; i < argc; ++i)
    if (argv[i] == std::string("distorted"))
      is_distorted = true;
    else
      assignments.emplace_back(argv[i]);
  const auto parameters = parameters_of(assignments, Problem::declare);
  CoarseMesh<dim> mesh  = SmallBody<dim>(parameters).body.mesh;
  if (is_distorted)
    mesh = distorted(std::move(mesh));
  Problem problem(parameters, &mesh);
  measure(method, problem);
}
