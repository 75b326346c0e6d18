// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/condensed/condensed_solver.h>

// The forces that resist a displacement, with those of a foundation.

namespace Setsudan
{
using namespace dealii;

template <int dim>
LA::Vector
CondensedSolver<dim>::foundation_forces(const LA::Vector &displacement) const
{
  LA::Vector forces = model.discretization.zero_vector();
  if (foundation.empty())
    return forces;
  const auto &owned  = model.discretization.owned;
  const auto lengths = work_of(foundation, displacement);
  for (unsigned int i = 0; i < foundation.size(); ++i)
    for (const auto &[unknown, factor] : foundation[i])
      if (owned.is_element(unknown))
        forces(unknown) += factor * lengths[i];
  forces.compress(VectorOperation::add);
  return forces;
}



template <int dim>
LA::Vector
CondensedSolver<dim>::resisting_forces(const LA::Vector &displacement) const
{
  LA::Vector forces = internal_forces(model, displacement);
  if (!foundation.empty())
    forces += foundation_forces(displacement);
  return forces;
}



#define INSTANTIATE(dim)                                       \
  template LA::Vector CondensedSolver<dim>::foundation_forces( \
    const LA::Vector &) const;                                 \
  template LA::Vector CondensedSolver<dim>::resisting_forces(  \
    const LA::Vector &) const;

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
