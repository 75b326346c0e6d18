#include <deal.II/lac/solver_cg.h>

#include <setsudan/solver/iterative_solver.h>

#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

namespace Setsudan
{
using namespace dealii;

IterativeSolver::IterativeSolver(const SolverParameters &parameters)
  : parameters(parameters)
{
}



void
IterativeSolver::initialize(const LA::SparseMatrix &new_matrix,
                            const std::vector<std::vector<double>> &rigid_modes)
{
  matrix = &new_matrix;
  null_space.clear();
  for (const auto &mode : rigid_modes)
    null_space.insert(null_space.end(), mode.begin(), mode.end());

  // A threshold of 0 keeps all couplings: those of serendipity elements are
  // too uneven for a positive one to choose among. A plane has 3 rigid modes,
  // space has 6.
  Teuchos::ParameterList list;
  ML_Epetra::SetDefaults("SA", list);
  list.set("ML output", 0);
  list.set("PDE equations", rigid_modes.size() == 3 ? 2 : 3);
  list.set("aggregation: threshold", 0.0);
  list.set("smoother: type", "Chebyshev");
  list.set("smoother: sweeps", 2);
  list.set("coarse: type", "Amesos-KLU");
  list.set("coarse: max size", 1000);
  list.set("null space: type", "pre-computed");
  list.set("null space: dimension", static_cast<int>(rigid_modes.size()));
  list.set("null space: vectors", null_space.data());
  multigrid.initialize(*matrix, list);
}



void
IterativeSolver::solve(LA::Vector &x, const LA::Vector &b)
{
  const double forces = b.l2_norm();
  if (forces == 0)
    {
      x = 0;
      return;
    }
  SolverControl control(parameters.max_iterations,
                        parameters.tolerance * forces);
  try
    {
      SolverCG<LA::Vector>(control).solve(*matrix, x, b, multigrid);
    }
  catch (const SolverControl::NoConvergence &)
    {
      throw SolverError(
        "Conjugate gradients reached a relative residual of " +
        std::to_string(control.last_value() / forces) + " after " +
        std::to_string(control.last_step()) +
        " iterations and not Solver/Tolerance. Set Solver/Method = direct, or "
        "allow more iterations with Solver/Maximum iterations.");
    }
}



void
IterativeSolver::approximate(LA::Vector &x, const LA::Vector &b)
{
  multigrid.vmult(x, b);
}



std::string
IterativeSolver::description() const
{
  return "iterative (conjugate gradients with algebraic multigrid)";
}



bool
IterativeSolver::is_iterative() const
{
  return true;
}
} // namespace Setsudan
