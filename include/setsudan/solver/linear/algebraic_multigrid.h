// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/trilinos_precondition.h>

#include <vector>

namespace Setsudan
{
/** Trilinos' smoothed aggregation (ML), which knows the rigid motions of the
 * body. */
class AlgebraicMultigrid : public dealii::TrilinosWrappers::PreconditionAMG
{
public:
  /**
   * @param matrix      must live as long.
   * @param rigid_modes for each rigid motion its value in every unknown of this
   *   process.
   */
  void
  initialize(const Epetra_RowMatrix &matrix,
             const std::vector<std::vector<double>> &rigid_modes);

private:
  /** The modes, one behind the other; ML keeps a pointer to them. */
  std::vector<double> null_space;
};
} // namespace Setsudan
