// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/stage_compliance.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
std::unique_ptr<StageCompliance<dim>>
StageCompliance<dim>::make(CutBody<dim> &body,
                           StageForces forces,
                           const unsigned int last)
{
  if (body.cut_strategy().kind == CutStrategy::condensed)
    return std::make_unique<CondensedStageCompliance<dim>>(body, forces, last);
  return std::make_unique<IterativeStageCompliance<dim>>(
    body, std::move(forces), last);
}



template <int dim>
CondensedStageCompliance<dim>::CondensedStageCompliance(
  CutBody<dim> &body,
  const StageForces &forces,
  const unsigned int last)
  : body(body)
  // With all rows split, which says whether all that is cut is held.
  , solver(body.condensed_solver(last))
{
  for (unsigned int n = 0; n <= last; ++n)
    n_free.push_back(body.condensed_solver(n)->n_free());
  compliance =
    solver->compliance(forces.vectors, body.model().loads, body.model().lift);
  of_stage.matrix.reinit(forces.vectors.size() + 1);
  ahead = of_stage;
}



template <int dim>
void
CondensedStageCompliance<dim>::advance(Products &products,
                                       const unsigned int n) const
{
  if (n == products.n_summed)
    return;
  // Of one process, since round-off decides where contacts change.
  const MPI_Comm communicator = body.communicator();
  if (Utilities::MPI::this_mpi_process(communicator) == 0)
    compliance.add_products(products.n_summed, n, products.matrix);
  Utilities::MPI::broadcast(
    &products.matrix(0, 0), products.matrix.n_elements(), 0, communicator);
  products.n_summed = n;
}



template <int dim>
const LAPACKFullMatrix<double> &
CondensedStageCompliance<dim>::products(const unsigned int n_split)
{
  const unsigned int n = n_free[n_split];
  const bool is_ahead  = n > last_asked;
  last_asked           = n;
  if (is_ahead)
    {
      if (ahead.n_summed > n || ahead.n_summed < of_stage.n_summed)
        ahead = of_stage;
      advance(ahead, n);
      return ahead.matrix;
    }
  if (n < of_stage.n_summed)
    {
      of_stage.matrix   = 0;
      of_stage.n_summed = 0;
    }
  advance(of_stage, n);
  return of_stage.matrix;
}



template <int dim>
const std::vector<double> &
CondensedStageCompliance<dim>::work_in_lift() const
{
  return compliance.work_in_lift;
}



template <int dim>
bool
CondensedStageCompliance<dim>::is_of_present_body() const
{
  return solver == body.condensed_solver();
}



template class StageCompliance<2>;
template class StageCompliance<3>;
template class CondensedStageCompliance<2>;
template class CondensedStageCompliance<3>;
} // namespace Setsudan
