#include <setsudan/solver/cholesky_solver.h>

namespace Setsudan
{
void
CholeskySolver::initialize(const LA::SparseMatrix &matrix,
                           const std::vector<std::vector<double>> &)
{
  factor.reset();
  factor =
    std::make_unique<CholeskyFactor>(matrix, std::vector<unsigned int>(), 0.);
}



void
CholeskySolver::solve(LA::Vector &x, const LA::Vector &b)
{
  factor->from_order(
    factor->solve_upper(factor->solve_lower(factor->in_order(b))), x);
}



std::string
CholeskySolver::description() const
{
  return "direct (CHOLMOD)";
}
} // namespace Setsudan
