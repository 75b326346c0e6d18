#pragma once

#include <vector>

namespace Setsudan
{
/** The Cholesky factor of a dense matrix that grows: rows and columns are added
 * at its end, and what was factored stays. */
class GrowingCholesky
{
public:
  /** @param most how many unknowns there may be in the end. */
  explicit GrowingCholesky(const unsigned int most);

  unsigned int
  size() const;

  /**
   * Add unknowns.
   *
   * @param rows the new rows of the matrix up to the diagonal, one behind the
   *   other, each with as many entries as there are unknowns then.
   * @throw SolverError where the matrix is not positive definite.
   */
  void
  append(const std::vector<std::vector<double>> &rows);

  /** Forget the last unknowns. */
  void
  shrink(const unsigned int n);

  /** Solve for all unknowns there are. */
  void
  solve(std::vector<double> &x) const;

private:
  const unsigned int most;
  unsigned int n = 0;
  /** By columns of length `most`; below the diagonal. */
  std::vector<double> factor;
};
} // namespace Setsudan
