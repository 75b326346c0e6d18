// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/linear/algebraic_multigrid.h>

#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

namespace Setsudan
{
void
AlgebraicMultigrid::initialize(
  const Epetra_RowMatrix &matrix,
  const std::vector<std::vector<double>> &rigid_modes)
{
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
  PreconditionAMG::initialize(matrix, list);
}
} // namespace Setsudan
