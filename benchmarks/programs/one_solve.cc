// SPDX-License-Identifier: LGPL-2.1-or-later
// One solve of a block of N^3 elements that stands on its bottom and is loaded
// on its top: one_solve METHOD N [distorted] [ASSIGNMENT...]. METHOD is
// multigrid (over the order of the functions, without a matrix), algebraic
// (multigrid of the assembled matrix) or direct; assignments as the command
// line of the program has them, of which Body/Refinement=n refines all elements
// so often. Prints names and values in a line: seconds are those of the whole
// run, of making the mesh and the loads, of the set-up and of the solve; memory
// is the peak of a process in MB; messages and bytes are those of an iteration
// that a process sends, the most of all processes.

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <setsudan/kernel/blas.h>
#include <setsudan/solver/assembled_solver.h>
#include <setsudan/solver/matrix_free_solver.h>

#include <sys/resource.h>

#include <iostream>
#include <string>

#include "../../tests/mechanics/small_model.h"
#include "message_count.h"

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
    : SmallModel<dim>(
        parameters,
        mesh,
        Refinement{BodyParameters<dim>(parameters).refinement, {}})
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


/** The largest of all processes, printed by the first one. */
void
print(const char *name, const double own)
{
  const double largest = Utilities::MPI::max(own, MPI_COMM_WORLD);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << name << " " << largest << " ";
}


std::unique_ptr<TangentSolver>
make_solver(const std::string &method, Problem &problem)
{
  auto &model = problem.model;
  if (method == "multigrid")
    return std::make_unique<MatrixFreeSolver<dim>>(
      model, model.supports, problem.solver);
  return std::make_unique<AssembledSolver<dim>>(
    model,
    model.supports,
    problem.solver,
    choose_assembled(problem.solver, size_of(model.discretization)));
}


void
measure(const std::string &method, Problem &problem)
{
  auto &model           = problem.model;
  const LA::Vector zero = model.discretization.zero_vector();
  Timer timer;
  const auto solver   = make_solver(method, problem);
  const double set_up = timer.wall_time();
  const auto before   = message_count();
  timer.restart();
  const auto solution       = solver->solve(model.loads, model.lift, zero);
  const double solve        = timer.wall_time();
  const auto after          = message_count();
  unsigned int n_iterations = 0;
  if (method == "multigrid")
    n_iterations = static_cast<MatrixFreeSolver<dim> &>(*solver).n_iterations();
  print("unknowns", model.discretization.dof_handler.n_dofs());
  print("iterations", n_iterations);
  print("set_up", set_up);
  print("solve", solve);
  print("residual", solution.quality.residual);
  print("memory", peak_memory());
  const double n = std::max(n_iterations, 1u);
  print("messages", (after.messages - before.messages) / n);
  print("bytes", (after.bytes - before.bytes) / n);
  print("collectives", (after.collectives - before.collectives) / n);
}
} // namespace


int
main(int argc, char **argv)
{
  const Timer program;
  start_with_fitting_blas(argv);
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
  Timer timer;
  Problem problem(parameters, &mesh);
  const double made = timer.wall_time();
  measure(method, problem);
  print("model", made);
  print("program", program.wall_time());
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << std::endl;
}
