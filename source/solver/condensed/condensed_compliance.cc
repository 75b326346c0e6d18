// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/condensed/condensed_solver.h>
#include <setsudan/space/first_process.h>

#include <Teuchos_BLAS.hpp>

#include <algorithm>

// What forces on the interface do to each other.

namespace Setsudan
{
using namespace dealii;

template <int dim>
void
CondensedSolver<dim>::Compliance::add_products(
  const unsigned int begin,
  const unsigned int end,
  LAPACKFullMatrix<double> &products) const
{
  const int n = half_displacements.n();
  if (begin == end)
    return;
  const Teuchos::BLAS<int, double> blas;
  blas.SYRK(Teuchos::LOWER_TRI,
            Teuchos::TRANS,
            n,
            end - begin,
            1.,
            &half_displacements(begin, 0),
            half_displacements.m(),
            1.,
            &products(0, 0),
            n);
}



template <int dim>
typename CondensedSolver<dim>::Compliance
CondensedSolver<dim>::compliance(const std::vector<UnknownForces> &on_interface,
                                 const LA::Vector &loads,
                                 const LA::Vector &lift)
{
  Compliance result;
  const LA::Vector whole_lift = gather(lift);
  const LA::Vector whole_loads =
    gather(condense(*base, residual_of_lift(loads, lift)));
  if (is_first)
    {
      std::vector<UnknownForces> numbered;
      for (const auto &forces : on_interface)
        {
          result.work_in_lift.push_back(0);
          numbered.push_back(placed_on_cut(
            forces, [&](const unsigned int unknown, const double force) {
              result.work_in_lift.back() += force * whole_lift(unknown);
            }));
        }
      const auto forces = condensation->forward_eliminate(whole_loads).on_cut;
      numbered.emplace_back();
      for (unsigned int i = 0; i < cut.size(); ++i)
        numbered.back().emplace_back(i, forces[i]);
      result.half_displacements = interface->half_displacements(numbered);
    }
  result.work_in_lift =
    of_first_process(communicator, [&] { return result.work_in_lift; });
  return result;
}



#define INSTANTIATE(dim)                                                       \
  template void CondensedSolver<dim>::Compliance::add_products(                \
    const unsigned int, const unsigned int, LAPACKFullMatrix<double> &) const; \
  template typename CondensedSolver<dim>::Compliance                           \
  CondensedSolver<dim>::compliance(const std::vector<UnknownForces> &,         \
                                   const LA::Vector &,                         \
                                   const LA::Vector &);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
