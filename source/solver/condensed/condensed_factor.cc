// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/condensed/condensed_solver.h>
#include <setsudan/solver/linear/linear_solver.h>
#include <setsudan/space/first_process.h>

// The stiffness or tangent that a cut is condensed from.

namespace Setsudan
{
using namespace dealii;

template <int dim>
void
CondensedSolver<dim>::condense_onto_cut(const LA::SparseMatrix &matrix)
{
  if (!is_first)
    return;
  // Before there is another one, which is as large.
  interface.reset();
  condensation.reset();
  condensation = std::make_unique<StaticCondensation>(matrix, cut);
  std::vector<std::vector<std::pair<unsigned int, double>>> springs;
  for (const auto &vector : foundation)
    {
      springs.emplace_back();
      for (const auto &[place, factor] : placed_on_cut(vector, {}))
        springs.back().emplace_back(place, factor);
    }
  condensation->add_foundation(springs);
  interface = std::make_unique<InterfaceSystem>(cut, condensation->stiffness());
}



template <int dim>
void
CondensedSolver<dim>::condense_at_rest()
{
  LA::SparseMatrix matrix;
  assemble_stiffness(model.discretization, model.stiffness, *base, matrix);
  largest_entry = matrix.linfty_norm();
  if (Utilities::MPI::n_mpi_processes(communicator) == 1)
    condense_onto_cut(matrix);
  else
    condense_onto_cut(gather(matrix));
}



template <int dim>
void
CondensedSolver<dim>::linearize(const Linearization &linearization)
{
  LA::SparseMatrix matrix;
  assemble_tangent(model, linearization, *base, matrix);
  try
    {
      condense_onto_cut(matrix);
      set_constraints(constraints);
    }
  catch (const SolverError &)
    {
      condense_at_rest();
      set_constraints(constraints);
      throw;
    }
}



#define INSTANTIATE(dim)                                  \
  template void CondensedSolver<dim>::condense_onto_cut(  \
    const LA::SparseMatrix &);                            \
  template void CondensedSolver<dim>::condense_at_rest(); \
  template void CondensedSolver<dim>::linearize(const Linearization &);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
