// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/multigrid/p_multigrid.h>

namespace Setsudan
{
using namespace dealii;

namespace
{
// The smoother's polynomial, and the part of the spectrum that it damps: that
// above the largest eigenvalue over this number.
constexpr unsigned int degree  = 3;
constexpr double range         = 15;
constexpr unsigned int n_steps = 15;
} // namespace


template <int dim>
PMultigrid<dim>::PMultigrid(
  const ConstrainedStiffness<dim> &stiffness,
  std::shared_ptr<const CoarseCorrection<dim>> coarse_correction)
  : stiffness(stiffness)
  , coarse(std::move(coarse_correction))
  , rest(stiffness.batches.partitioner())
{
  typename Smoother::AdditionalData data;
  data.degree              = degree;
  data.smoothing_range     = range;
  data.eig_cg_n_iterations = n_steps;
  Vector diagonal(rest);
  stiffness.diagonal(diagonal);
  for (double &entry : diagonal)
    entry = 1 / entry;
  data.preconditioner = std::make_shared<DiagonalMatrix<Vector>>(diagonal);
  smoother.initialize(stiffness, data);
}



template <int dim>
void
PMultigrid<dim>::vmult(Vector &result, const Vector &forces) const
{
  smoother.vmult(result, forces);
  stiffness.vmult(rest, result);
  rest.sadd(-1., 1., forces);
  coarse->add(result, rest, stiffness.lines);
  smoother.step(result, forces);
}



template class PMultigrid<2>;
template class PMultigrid<3>;
} // namespace Setsudan
