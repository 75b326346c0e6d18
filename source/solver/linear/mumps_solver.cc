// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/linear/mumps_solver.h>

#include <Amesos_Mumps.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_FEVector.h>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>

namespace Setsudan
{
namespace
{
// MUMPS's errors for a workspace that is too small (INFOG(1); users' guide).
constexpr int integers_too_small = -8;
constexpr int reals_too_small    = -9;
// More than this beyond MUMPS's estimate would hide another error.
constexpr int most_spare_percent = 2000;

void
check(const int error, const std::string &what)
{
  if (error != 0)
    throw SolverError("The direct solver's " + what + " failed (Amesos error " +
                      std::to_string(error) +
                      "): the matrix is singular to working precision, or "
                      "memory ran out. Check that supports hold the body, or "
                      "set Solver/Method = iterative.");
}
} // namespace


MumpsSolver::MumpsSolver(const int spare_percent, const bool is_definite)
  : spare_percent(spare_percent)
  , is_definite(is_definite)
{
}



MumpsSolver::~MumpsSolver() = default;


void
MumpsSolver::initialize(const LA::SparseMatrix &matrix,
                        const std::vector<std::vector<double>> &)
{
  // Amesos' interface is not const-correct; it does not change the matrix.
  mumps.reset();
  // Amesos looks at vectors that are set, and those of the last solve are gone.
  problem.SetLHS(nullptr);
  problem.SetRHS(nullptr);
  problem.SetOperator(
    const_cast<Epetra_CrsMatrix *>(&matrix.trilinos_matrix()));
  for (int percent = spare_percent; !factorize(percent);)
    percent = 2 * std::max(percent, 50);
}



bool
MumpsSolver::factorize(const int percent)
{
  auto solver = std::make_unique<Amesos_Mumps>(problem);
  Teuchos::ParameterList parameters;
  parameters.set("MatrixProperty", is_definite ? "SPD" : "symmetric");
  check(solver->SetParameters(parameters), "set-up");
  solver->SetICNTL(14, percent);
  check(solver->SymbolicFactorization(), "symbolic factorization");
  const int error = solver->NumericFactorization();
  // The host alone knows, for all processes.
  int status = solver->GetINFOG()[0];
  problem.GetOperator()->Comm().Broadcast(&status, 1, 0);
  const bool too_small =
    status == integers_too_small || status == reals_too_small;
  if (too_small && percent < most_spare_percent)
    return false;
  check(error, "numeric factorization");
  // What MUMPS factors as a positive definite matrix it counts negative pivots
  // of.
  int n_negative = solver->GetINFOG()[11];
  problem.GetOperator()->Comm().Broadcast(&n_negative, 1, 0);
  if (is_definite && n_negative > 0)
    throw NotDefiniteError(
      "The direct solver's factorization found a matrix that is not positive "
      "definite. Check that supports hold the body.");
  mumps = std::move(solver);
  return true;
}



void
MumpsSolver::solve(LA::Vector &x, const LA::Vector &b)
{
  problem.SetLHS(&x.trilinos_vector());
  problem.SetRHS(const_cast<Epetra_MultiVector *>(&b.trilinos_vector()));
  check(mumps->Solve(), "solve");
}
} // namespace Setsudan
