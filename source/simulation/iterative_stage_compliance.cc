// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/stage_compliance.h>

#include <deal.II/lac/full_matrix.h>

#include <Teuchos_BLAS.hpp>

#include <algorithm>
#include <numeric>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Of a force that acts on ties or supports alone, round-off remains. */
constexpr double nothing_left = 1e-13;

/** The entries of a vector that this process has. */
std::vector<double>
own_entries(const LA::Vector &vector)
{
  const double *const begin = vector.trilinos_vector()[0];
  return {begin, begin + vector.locally_owned_size()};
}



/** The products of columns of two lists, over the entries of this process;
 * those of the second list are numbered. */
FullMatrix<double>
products_of_columns(const std::vector<std::vector<double>> &as,
                    const std::map<unsigned int, std::vector<double>> &bs)
{
  // So many entries at once as the processor's cache holds of some columns.
  constexpr unsigned int at_once = 512;
  const unsigned int n = as.size(), n_entries = n > 0 ? as[0].size() : 0;
  FullMatrix<double> products(n, n);
  std::vector<double> a, b;
  const Teuchos::BLAS<int, double> blas;
  for (unsigned int begin = 0; begin < n_entries; begin += at_once)
    {
      const unsigned int end = std::min(begin + at_once, n_entries);
      a.clear();
      b.clear();
      for (const auto &column : as)
        a.insert(a.end(), column.begin() + begin, column.begin() + end);
      for (const auto &[number, column] : bs)
        b.insert(b.end(), column.begin() + begin, column.begin() + end);
      // A matrix of deal.II has its rows one after the other.
      blas.GEMM(Teuchos::TRANS,
                Teuchos::NO_TRANS,
                n,
                n,
                end - begin,
                1.,
                b.data(),
                end - begin,
                a.data(),
                end - begin,
                1.,
                &products(0, 0),
                n);
    }
  return products;
}
} // namespace


template <int dim>
IterativeStageCompliance<dim>::IterativeStageCompliance(
  CutBody<dim> &body,
  StageForces stage_forces,
  const unsigned int last)
  : body(body)
  , forces(std::move(stage_forces))
  , n_changes(body.n_changes())
  , loads(body.model().loads)
{
  Assert(body.model().is_linear(),
         ExcMessage("Products are those of a linear body."));
  // Says whether all that is cut is held.
  body.constraints_after(last);
  const LA::Vector &lift = body.model().lift;
  loads -= internal_forces(body.model(), lift);
  in_lift = work_of(forces.vectors, lift);
}



template <int dim>
LA::Vector
IterativeStageCompliance<dim>::force(const unsigned int number) const
{
  if (number == forces.vectors.size())
    return loads;
  return vector_of(forces.vectors[number],
                   body.model().discretization.zero_vector());
}



template <int dim>
LAPACKFullMatrix<double>
IterativeStageCompliance<dim>::solve_stage(const unsigned int n_split)
{
  const auto constraints =
    std::make_shared<const typename CutBody<dim>::Constraints>(
      body.constraints_after(n_split));
  const auto solver     = body.solver(constraints);
  const LA::Vector zero = body.model().discretization.zero_vector();
  auto of_stage         = forces.of_stage(n_split);
  of_stage.push_back(forces.vectors.size());
  Assert(std::is_sorted(of_stage.begin(), of_stage.end()), ExcInternalError());
  auto before = std::move(displacements);
  displacements.clear();
  Columns residuals;
  for (const unsigned int i : of_stage)
    {
      LA::Vector residual = force(i);
      if (condense(*constraints, residual).l2_norm() <=
          nothing_left * residual.l2_norm())
        continue;
      LA::Vector guess = zero;
      if (const auto found = before.find(i); found != before.end())
        {
          std::copy(found->second.begin(),
                    found->second.end(),
                    guess.trilinos_vector()[0]);
          before.erase(found);
        }
      const Solution solution = solver->solve(residual, zero, guess);
      residual -= solution.internal;
      displacements[i] = own_entries(solution.displacement);
      residuals.push_back(own_entries(residual));
    }
  return multiply(residuals);
}



template <int dim>
LAPACKFullMatrix<double>
IterativeStageCompliance<dim>::multiply(const Columns &residuals) const
{
  const unsigned int n = forces.vectors.size() + 1;
  const auto by_error  = products_of_columns(residuals, displacements);
  const auto of_loads  = own_entries(loads);
  const auto &owned    = body.model().discretization.owned;
  LAPACKFullMatrix<double> sums(n);
  unsigned int column = 0;
  for (const auto &[j, displacement] : displacements)
    {
      for (unsigned int i = 0; i + 1 < n; ++i)
        for (const auto &[unknown, factor] : forces.vectors[i])
          if (owned.is_element(unknown))
            sums(i, j) +=
              factor * displacement[owned.index_within_set(unknown)];
      sums(n - 1, j) += std::inner_product(
        of_loads.begin(), of_loads.end(), displacement.begin(), 0.);
      unsigned int row = 0;
      for (const auto &[i, other] : displacements)
        sums(i, j) += by_error(column, row++);
      ++column;
    }
  // Of two forces of which only one has a displacement that one says all.
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < j; ++i)
      {
        const bool has_both =
          displacements.count(i) > 0 && displacements.count(j) > 0;
        sums(i, j) = sums(j, i) =
          (sums(i, j) + sums(j, i)) / (has_both ? 2. : 1.);
      }
  const ArrayView<double> entries(&sums(0, 0), n * n);
  Utilities::MPI::sum(
    ArrayView<const double>(entries), body.communicator(), entries);
  // Of one process, since round-off decides where contacts change.
  Utilities::MPI::broadcast(&sums(0, 0), n * n, 0, body.communicator());
  return sums;
}



template <int dim>
const LAPACKFullMatrix<double> &
IterativeStageCompliance<dim>::products(const unsigned int n_split)
{
  // Stages ahead are looked at before the next one is, and needed again then.
  if (n_split <= last_asked)
    known.erase(known.begin(), known.lower_bound(n_split));
  last_asked       = n_split;
  const auto found = known.find(n_split);
  if (found != known.end())
    return found->second;
  return known.emplace(n_split, solve_stage(n_split)).first->second;
}



template <int dim>
const std::vector<double> &
IterativeStageCompliance<dim>::work_in_lift() const
{
  return in_lift;
}



template <int dim>
bool
IterativeStageCompliance<dim>::is_of_present_body() const
{
  return n_changes == body.n_changes();
}



template class IterativeStageCompliance<2>;
template class IterativeStageCompliance<3>;
} // namespace Setsudan
