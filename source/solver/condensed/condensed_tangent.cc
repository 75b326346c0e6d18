// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/parameters/exceptions.h>
#include <setsudan/solver/condensed/condensed_tangent.h>
#include <setsudan/solver/tangent_solver.h>
#include <setsudan/space/first_process.h>

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace Setsudan
{
using namespace dealii;

template <int dim>
CondensedTangent<dim>::CondensedTangent(
  const ElasticModel<dim> &model,
  const AffineConstraints<double> &constraints,
  const std::vector<UnknownForces> &all_forces,
  const std::vector<UnknownForces> &all_springs)
  : model(model)
  , constraints(constraints)
  , communicator(model.discretization.communicator)
  , is_first(Utilities::MPI::this_mpi_process(communicator) == 0)
{
  auto on_unknowns = condensed(all_forces);
  auto by_springs  = condensed(all_springs);
  for (const auto *vectors : {&on_unknowns, &by_springs})
    for (const auto &vector : *vectors)
      for (const auto &force : vector)
        interface.push_back(force.first);
  std::sort(interface.begin(), interface.end());
  interface.erase(std::unique(interface.begin(), interface.end()),
                  interface.end());
  forces  = placed(std::move(on_unknowns));
  springs = placed(std::move(by_springs));
}



template <int dim>
std::vector<UnknownForces>
CondensedTangent<dim>::condensed(const std::vector<UnknownForces> &all) const
{
  // A process knows the constraints of its own unknowns.
  std::vector<UnknownForces> own(all.size());
  std::vector<double> size(all.size(), 0.);
  for (unsigned int v = 0; v < all.size(); ++v)
    for (const auto &[unknown, force] : all[v])
      {
        size[v] = std::max(size[v], std::abs(force));
        if (!model.discretization.owned.is_element(unknown))
          continue;
        if (!constraints.is_constrained(unknown))
          own[v].emplace_back(unknown, force);
        else
          for (const auto &[other, weight] :
               *constraints.get_constraint_entries(unknown))
            own[v].emplace_back(other, weight * force);
      }
  std::vector<std::map<types::global_dof_index, double>> sums(all.size());
  for (const auto &of_process : Utilities::MPI::all_gather(communicator, own))
    for (unsigned int v = 0; v < all.size(); ++v)
      for (const auto &[unknown, force] : of_process[v])
        sums[v][unknown] += force;
  // What acts on ties cancels.
  constexpr double nothing_left = 1e-13;
  std::vector<UnknownForces> result(all.size());
  for (unsigned int v = 0; v < all.size(); ++v)
    for (const auto &[unknown, force] : sums[v])
      if (std::abs(force) > nothing_left * size[v])
        result[v].emplace_back(unknown, force);
  return result;
}



template <int dim>
std::vector<UnknownForces>
CondensedTangent<dim>::placed(std::vector<UnknownForces> vectors) const
{
  for (auto &vector : vectors)
    for (auto &force : vector)
      force.first =
        std::lower_bound(interface.begin(), interface.end(), force.first) -
        interface.begin();
  return vectors;
}



template <int dim>
void
CondensedTangent<dim>::linearize(const LA::Vector &displacement,
                                 const double shift)
{
  assemble_tangent(model, {&displacement}, constraints, matrix);
  if (shift > 0)
    {
      double sum = 0;
      for (const auto i : matrix.locally_owned_range_indices())
        sum += std::abs(matrix.diag_element(i));
      sum = Utilities::MPI::sum(sum, communicator);
      for (const auto i : matrix.locally_owned_range_indices())
        matrix.add(i, i, shift * sum / matrix.m());
      matrix.compress(VectorOperation::add);
    }
  if (Utilities::MPI::n_mpi_processes(communicator) == 1)
    factorize(matrix);
  else
    {
      const auto whole = gather(matrix);
      of_first_process(communicator, [&] {
        factorize(whole);
        return true;
      });
    }
  n_negative_ones =
    of_first_process(communicator, [&] { return factor->n_negative(); });
}



template <int dim>
void
CondensedTangent<dim>::factorize(const LA::SparseMatrix &whole)
{
  if (condensation)
    condensation->update(whole);
  else
    condensation = std::make_unique<StaticCondensation>(whole, interface);
  const auto &schur    = condensation->stiffness();
  const unsigned int n = interface.size();
  LAPACKFullMatrix<double> stiffness(n);
  for (unsigned int column = 0; column < n; ++column)
    for (unsigned int row = column; row < n; ++row)
      stiffness(row, column) = schur(row, column);
  for (const auto &spring : springs)
    for (const auto &[column, factor] : spring)
      for (const auto &[row, other] : spring)
        if (row >= column)
          stiffness(row, column) += factor * other;
  factor = std::make_unique<SymmetricFactor>(std::move(stiffness));
}



template <int dim>
LAPACKFullMatrix<double>
CondensedTangent<dim>::products() const
{
  const unsigned int n = forces.size();
  LAPACKFullMatrix<double> result(n);
  if (is_first)
    {
      LAPACKFullMatrix<double> displacements(interface.size(), n);
      for (unsigned int v = 0; v < n; ++v)
        for (const auto &[place, force] : forces[v])
          displacements(place, v) = force;
      factor->solve(displacements);
      for (unsigned int v = 0; v < n; ++v)
        for (unsigned int w = 0; w < n; ++w)
          for (const auto &[place, force] : forces[w])
            result(w, v) += force * displacements(place, v);
    }
  // Of one process, since round-off decides where contacts change.
  if (n > 0)
    Utilities::MPI::broadcast(
      &result(0, 0), result.n_elements(), 0, communicator);
  return result;
}



template <int dim>
LA::Vector
CondensedTangent<dim>::increment(const LA::Vector &residual) const
{
  LA::Vector x           = model.discretization.zero_vector();
  const LA::Vector loads = gather(condense(constraints, residual));
  LA::Vector whole       = gather(x);
  if (is_first)
    {
      auto eliminated   = condensation->forward_eliminate(loads);
      auto on_interface = eliminated.on_cut;
      factor->solve(on_interface);
      condensation->back_substitute(std::move(eliminated), on_interface, whole);
    }
  scatter(whole, x);
  distribute(constraints, x);
  return x;
}



template <int dim>
double
CondensedTangent<dim>::round_off() const
{
  return round_off_of_forces(model.discretization, matrix.linfty_norm());
}



template class CondensedTangent<2>;
template class CondensedTangent<3>;
} // namespace Setsudan
