#include <setsudan/solver/linear/direct_solver.h>

#include <Amesos_Klu.h>
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


DirectSolver::DirectSolver(const dealii::types::global_dof_index n_unknowns,
                           const int spare_percent)
  : small(n_unknowns <= small_size)
  , spare_percent(spare_percent)
{
}



DirectSolver::~DirectSolver() = default;


void
DirectSolver::initialize(const LA::SparseMatrix &matrix,
                         const std::vector<std::vector<double>> &)
{
  // Amesos' interface is not const-correct; it does not change the matrix.
  amesos.reset();
  // Amesos looks at vectors that are set, and those of the last solve are gone.
  problem.SetLHS(nullptr);
  problem.SetRHS(nullptr);
  problem.SetOperator(
    const_cast<Epetra_CrsMatrix *>(&matrix.trilinos_matrix()));
  if (small)
    {
      amesos = std::make_unique<Amesos_Klu>(problem);
      check(amesos->SymbolicFactorization(), "symbolic factorization");
      check(amesos->NumericFactorization(), "numeric factorization");
      return;
    }
  for (int percent = spare_percent; !factorize_with_mumps(percent);)
    percent = 2 * std::max(percent, 50);
}



bool
DirectSolver::factorize_with_mumps(const int percent)
{
  auto mumps = std::make_unique<Amesos_Mumps>(problem);
  Teuchos::ParameterList parameters;
  parameters.set("MatrixProperty", "SPD");
  check(mumps->SetParameters(parameters), "set-up");
  mumps->SetICNTL(14, percent);
  check(mumps->SymbolicFactorization(), "symbolic factorization");
  const int error = mumps->NumericFactorization();
  // The host alone knows, for all processes.
  int status = mumps->GetINFOG()[0];
  problem.GetOperator()->Comm().Broadcast(&status, 1, 0);
  const bool too_small =
    status == integers_too_small || status == reals_too_small;
  if (too_small && percent < most_spare_percent)
    return false;
  check(error, "numeric factorization");
  amesos = std::move(mumps);
  return true;
}



void
DirectSolver::solve(LA::Vector &x, const LA::Vector &b)
{
  problem.SetLHS(&x.trilinos_vector());
  problem.SetRHS(const_cast<Epetra_MultiVector *>(&b.trilinos_vector()));
  check(amesos->Solve(), "solve");
}



std::string
DirectSolver::description() const
{
  return small ? "direct (KLU)" : "direct (MUMPS, Cholesky)";
}
} // namespace Setsudan
