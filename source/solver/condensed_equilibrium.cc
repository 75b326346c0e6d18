#include <setsudan/solver/condensed_equilibrium.h>
#include <setsudan/solver/linear_solver.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
// Ties are of factors about 1.
constexpr double round_off = 1e-13;


/** A shift that makes even a body definite that only its cut holds: of the size
 * of the stiffness there, so that taking it off again loses no digits. */
double
shift_of(const LA::SparseMatrix &matrix, const std::vector<unsigned int> &cut)
{
  double sum = 0;
  for (const unsigned int unknown : cut)
    sum += matrix.diag_element(unknown);
  return cut.empty() ? 0 : sum / cut.size();
}
} // namespace


template <int dim>
CondensedEquilibrium<dim>::CondensedEquilibrium(
  ElasticModel<dim> &model,
  std::shared_ptr<const Constraints> base_constraints,
  const IndexSet &cut_unknowns)
  : model(model)
  , base(std::move(base_constraints))
{
  for (const auto unknown : cut_unknowns)
    if (!base->is_constrained(unknown))
      cut.push_back(unknown);
  LA::SparseMatrix matrix;
  assemble_stiffness(model.discretization, model.stiffness, *base, matrix);
  largest_entry      = matrix.linfty_norm();
  const double shift = shift_of(matrix, cut);
  factor             = std::make_unique<CholeskyFactor>(matrix, cut, shift);
  complement         = std::make_unique<SchurComplement>(*factor, shift);
  reduced            = std::make_unique<GrowingCholesky>(cut.size());
}



template <int dim>
double
CondensedEquilibrium<dim>::memory(const unsigned int n)
{
  // Both sides of the cut at once, each as L and as S, and what grows.
  return 8. * n * n * (1 + 0.5 + 0.5 + 1);
}



template <int dim>
bool
CondensedEquilibrium<dim>::columns_of(const Constraints &constraints,
                                      std::vector<unsigned int> &free,
                                      std::vector<Column> &columns) const
{
  const auto place_of = [&](const types::global_dof_index unknown) {
    const auto found = std::lower_bound(cut.begin(), cut.end(), unknown);
    return found != cut.end() && *found == unknown
             ? static_cast<int>(found - cut.begin())
             : -1;
  };
  std::vector<int> column_of(cut.size(), -1);
  for (unsigned int i = 0; i < cut.size(); ++i)
    if (!constraints.is_constrained(cut[i]))
      {
        column_of[i] = columns.size();
        free.push_back(i);
        columns.push_back({{i, 1.}});
      }
  for (unsigned int i = 0; i < cut.size(); ++i)
    if (column_of[i] < 0)
      for (const auto &[master, weight] :
           *constraints.get_constraint_entries(cut[i]))
        {
          const int place = place_of(master);
          if (place < 0 || column_of[place] < 0)
            return false;
          columns[column_of[place]].emplace_back(i, weight);
        }
  return true;
}



template <int dim>
bool
CondensedEquilibrium<dim>::set_constraints(
  std::shared_ptr<const Constraints> new_step)
{
  std::vector<unsigned int> free;
  std::vector<Column> columns;
  if (!columns_of(*new_step, free, columns))
    return false;
  const unsigned int n_kept = n_that_fit(free, columns);
  reduced->shrink(n_kept);
  free_unknowns.resize(n_kept);
  basis.resize(n_kept);

  std::vector<bool> is_known(cut.size(), false);
  for (const unsigned int i : free_unknowns)
    is_known[i] = true;
  std::vector<Column> added;
  for (unsigned int c = 0; c < free.size(); ++c)
    if (!is_known[free[c]])
      {
        free_unknowns.push_back(free[c]);
        added.push_back(std::move(columns[c]));
      }
  append(added);
  step = std::move(new_step);
  return true;
}



template <int dim>
unsigned int
CondensedEquilibrium<dim>::n_that_fit(const std::vector<unsigned int> &free,
                                      const std::vector<Column> &columns) const
{
  std::vector<int> column_of(cut.size(), -1);
  for (unsigned int c = 0; c < free.size(); ++c)
    column_of[free[c]] = c;
  // A displacement obeys the ties if it is what they make of its free unknowns.
  std::vector<double> rest(cut.size(), 0.);
  for (unsigned int c = 0; c < basis.size(); ++c)
    {
      if (column_of[free_unknowns[c]] < 0)
        return c;
      for (const auto &[i, value] : basis[c])
        rest[i] += value;
      for (const auto &[i, value] : basis[c])
        if (column_of[i] >= 0)
          for (const auto &[j, weight] : columns[column_of[i]])
            rest[j] -= weight * value;
      bool fits = true;
      for (const auto &[i, value] : basis[c])
        {
          if (column_of[i] >= 0)
            for (const auto &[j, weight] : columns[column_of[i]])
              {
                fits    = fits && std::abs(rest[j]) <= round_off;
                rest[j] = 0;
              }
          fits    = fits && std::abs(rest[i]) <= round_off;
          rest[i] = 0;
        }
      if (!fits)
        return c;
    }
  return basis.size();
}



template <int dim>
void
CondensedEquilibrium<dim>::append(const std::vector<Column> &columns)
{
  std::vector<std::vector<double>> rows;
  for (const auto &column : columns)
    {
      basis.push_back(column);
      std::vector<double> row(basis.size(), 0.);
      for (unsigned int c = 0; c < basis.size(); ++c)
        for (const auto &[i, weight] : column)
          for (const auto &[j, other] : basis[c])
            row[c] += weight * other * (*complement)(i, j);
      rows.push_back(std::move(row));
    }
  reduced->append(rows);
}



template <int dim>
LA::Vector
CondensedEquilibrium<dim>::solve_for(const LA::Vector &b) const
{
  auto ordered       = factor->solve_lower(factor->in_order(b));
  double *const last = ordered.data() + ordered.size() - cut.size();
  complement->multiply_lower(last);

  std::vector<double> q(basis.size(), 0.);
  for (unsigned int c = 0; c < basis.size(); ++c)
    for (const auto &[i, weight] : basis[c])
      q[c] += weight * last[i];
  reduced->solve(q);
  std::fill(last, last + cut.size(), 0.);
  for (unsigned int c = 0; c < basis.size(); ++c)
    for (const auto &[i, weight] : basis[c])
      last[i] += weight * q[c];

  complement->multiply_upper(last);
  LA::Vector x = b;
  factor->from_order(factor->solve_upper(ordered), x);
  base->distribute(x);
  return x;
}



template <int dim>
LA::Vector
CondensedEquilibrium<dim>::solve(const LA::Vector &forces,
                                 const LA::Vector &prescribed,
                                 const LA::Vector &)
{
  Mending mending;
  mending.rest_of = [&](const LA::Vector &displacement) {
    LA::Vector rest = forces;
    rest -= internal_forces(model, displacement);
    return rest;
  };
  mending.norm = [&](const LA::Vector &rest) {
    return condense(*step, rest).l2_norm();
  };
  mending.correction = [&](const LA::Vector &rest) {
    return solve_for(condense(*base, rest));
  };
  const LA::Vector b = mending.rest_of(prescribed);
  const double scale = mending.norm(b);
  check_loads(scale);
  LA::Vector x = mending.correction(b);
  x += prescribed;
  const LA::Vector rest = mend(x, scale * refined_above, mending);

  const double error = mending.norm(rest);
  quality            = quality_of(x, mending.correction(rest), error, scale);
  if (!is_accepted(error, scale, largest_entry, x))
    fail();
  return x;
}



template <int dim>
void
CondensedEquilibrium<dim>::fail() const
{
  std::ostringstream message;
  message << "The condensed solve left a relative residual of "
          << quality.residual << ", which must not exceed " << failed_above
          << ". Set Division/Solve = every row anew.";
  throw SolverError(message.str());
}



template <int dim>
SolveQuality
CondensedEquilibrium<dim>::quality_of_last() const
{
  return quality;
}



template class CondensedEquilibrium<2>;
template class CondensedEquilibrium<3>;
} // namespace Setsudan
