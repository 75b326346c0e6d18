#include <setsudan/solver/p_multigrid.h>

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
PMultigrid<dim>::PMultigrid(ElasticModel<dim> &model,
                            const AffineConstraints<double> &constraints,
                            const ConstrainedStiffness<dim> &stiffness)
  : stiffness(stiffness)
  , space(model, constraints, stiffness.lines)
  , coarse_stiffness(space.stiffness().matrix())
  , rest(stiffness.batches.partitioner())
  , coarse_forces(space.partitioner())
  , coarse_correction(space.partitioner())
{
  coarse_solver.initialize(*coarse_stiffness, space.rigid_modes());

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
  space.restrict_forces(coarse_forces, rest);
  coarse_solver.vmult(coarse_correction, coarse_forces);
  space.prolongate_and_add(result, coarse_correction);
  smoother.step(result, forces);
}



template class PMultigrid<2>;
template class PMultigrid<3>;
} // namespace Setsudan
