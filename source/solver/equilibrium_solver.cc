#include <setsudan/solver/equilibrium_solver.h>

#include <limits>

namespace Setsudan
{
bool
is_accepted(const double residual,
            const double loads,
            const double norm_of_matrix,
            const LA::Vector &x,
            const double accepted)
{
  // Beyond this a solve has failed in any case.
  constexpr double lost_above = 1e-5;
  const double round_off =
    10 * std::numeric_limits<double>::epsilon() * norm_of_matrix * x.l2_norm();
  // Written so that a residual that is not a number fails as well.
  return residual <= accepted * loads ||
         (residual <= round_off && residual <= lost_above * loads);
}
} // namespace Setsudan
