// SPDX-License-Identifier: LGPL-2.1-or-later
// The direct solvers, for small and for larger bodies, and the iterative one
// give the same displacement.

#include <setsudan/solver/linear/mumps_solver.h>

#include <deal.II/base/mpi.h>

#include <sstream>
#include <string>

#include "../mechanics/solved_model.h"
#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

template <int dim>
std::string
description(const SolvedModel<dim> &solved)
{
  return Setsudan::description(choose_assembled(
    solved.solver_parameters, size_of(solved.model.discretization)));
}


template <int dim>
void
compare(const std::string &n_elements, const std::string &load)
{
  const Assignments assignments = {"Body/Elements=" + n_elements,
                                   "Support/Fixed faces=left",
                                   "Material/Poisson's ratio=0.3",
                                   "Solver/Tolerance=1e-12",
                                   load};
  Assignments directly = assignments, iteratively = assignments;
  directly.push_back("Solver/Method=direct");
  iteratively.push_back("Solver/Method=iterative");
  const SolvedModel<dim> direct(directly), iterative(iteratively);

  LA::Vector difference = direct.displacement;
  difference -= iterative.displacement;
  const double largest = direct.displacement.linfty_norm();
  const double error   = difference.linfty_norm() / largest;
  if (is_first_process())
    {
      std::cout << dim << "D, " << description(direct) << " and "
                << description(iterative) << ": "
                << direct.model.discretization.dof_handler.n_dofs()
                << " unknowns, largest displacement " << largest << std::endl;
      check_below("difference", error, 1e-8);
    }
}


/** One matrix, several loads: what was solved before leaves no trace, and a
 * first guess changes nothing. */
void
test_many_loads(const std::string &n_elements, const std::string &method)
{
  SolvedModel<3> solved({"Body/Elements=" + n_elements,
                         "Support/Fixed faces=left",
                         "Load/Body force=0, 0, -1",
                         "Solver/Method=" + method,
                         "Solver/Tolerance=1e-12"});
  auto &model           = solved.model;
  const LA::Vector zero = model.discretization.zero_vector();
  AssembledSolver<3> solver(
    model,
    model.supports,
    solved.solver_parameters,
    choose_assembled(solved.solver_parameters, size_of(model.discretization)));
  LA::Vector twice = model.loads;
  twice *= 2;
  const LA::Vector first = solver.solve(twice, zero, zero).displacement;
  const LA::Vector rest  = solver.solve(zero, zero, first).displacement;
  LA::Vector again       = solver.solve(model.loads, zero, first).displacement;
  again -= solved.displacement;
  LA::Vector half = first;
  half.sadd(0.5, -1., solved.displacement);
  const double largest  = solved.displacement.linfty_norm();
  const double errors[] = {half.linfty_norm() / largest,
                           rest.linfty_norm() / largest,
                           again.linfty_norm() / largest};
  if (is_first_process())
    {
      std::cout << description(solved) << std::endl;
      check_below("twice the load", errors[0], 1e-8);
      check_below("no load", errors[1], 1e-8);
      check_below("again", errors[2], 1e-8);
    }
}


/** A factorization that is given too little room is repeated with more. */
void
test_small_workspace()
{
  SolvedModel<3> solved({"Body/Elements=8, 4, 4",
                         "Support/Fixed faces=left",
                         "Load/Body force=0, 0, -1",
                         "Solver/Method=direct"});
  auto &model = solved.model;
  LA::SparseMatrix matrix;
  assemble_stiffness(
    model.discretization, model.stiffness, model.supports, matrix);
  MumpsSolver scarce(-90);
  // Amesos says what went wrong at first, on streams that are compared.
  std::ostringstream said;
  auto *const out = std::cout.rdbuf(said.rdbuf());
  auto *const err = std::cerr.rdbuf(said.rdbuf());
  scarce.initialize(matrix, {});
  std::cout.rdbuf(out);
  std::cerr.rdbuf(err);
  LA::Vector x = model.discretization.zero_vector();
  scarce.solve(x, condense(model.supports, model.loads));
  x -= solved.displacement;
  const double error = x.linfty_norm() / solved.displacement.linfty_norm();
  if (is_first_process())
    check_below("too little workspace at first", error, 1e-10);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    compare<2>("6, 4", "Load/Tractions=right : 0.1, -0.2");
    compare<2>("30, 12", "Load/Tractions=right : 0.1, -0.2");
    compare<3>("3, 2, 2", "Load/Tractions=right : 0.1, 0.2, -0.2");
    compare<3>("8, 4, 4", "Load/Tractions=right : 0.1, 0.2, -0.2");
    test_many_loads("3, 2, 2", "direct");
    test_many_loads("8, 4, 4", "direct");
    test_many_loads("8, 4, 4", "iterative");
    test_small_workspace();
  });
}
