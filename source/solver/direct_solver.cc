#include <setsudan/solver/direct_solver.h>

#include <Amesos.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_FEVector.h>
#include <Teuchos_ParameterList.hpp>

namespace Setsudan
{
namespace
{
// Below this number of unknowns KLU's whole solve is a few milliseconds.
constexpr unsigned int small_size = 1500;

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


DirectSolver::DirectSolver(const dealii::types::global_dof_index n_unknowns)
  : small(n_unknowns <= small_size)
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
  amesos.reset(Amesos().Create(small ? "Amesos_Klu" : "Amesos_Mumps", problem));
  Teuchos::ParameterList parameters;
  parameters.set("MatrixProperty", "SPD");
  parameters.set("PrintTiming", false);
  check(amesos->SetParameters(parameters), "set-up");
  check(amesos->SymbolicFactorization(), "symbolic factorization");
  check(amesos->NumericFactorization(), "numeric factorization");
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



bool
DirectSolver::is_iterative() const
{
  return false;
}
} // namespace Setsudan
