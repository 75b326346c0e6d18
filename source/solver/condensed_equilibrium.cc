#include <setsudan/solver/condensed_equilibrium.h>
#include <setsudan/solver/linear_solver.h>

#include <algorithm>
#include <cmath>
#include <limits>
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
  // Both sides of the cut at once, each for itself, and what grows.
  return 8. * n * n * (1 + 0.5 + 1);
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
void
CondensedEquilibrium<dim>::eliminate(std::vector<double> &ordered,
                                     const bool is_remembered)
{
  if (!is_remembered)
    {
      factor->eliminate(ordered);
      return;
    }
  // From row to row the loads differ on the cut alone.
  const auto end = ordered.end() - cut.size();
  const std::vector<double> of_cut(end, ordered.end());
  std::fill(end, ordered.end(), 0.);
  if (ordered != remembered_loads)
    {
      remembered_loads = ordered;
      factor->eliminate(ordered);
      remembered = std::move(ordered);
    }
  ordered = remembered;
  for (unsigned int i = 0; i < cut.size(); ++i)
    ordered[ordered.size() - cut.size() + i] += of_cut[i];
}



template <int dim>
LA::Vector
CondensedEquilibrium<dim>::solve_for(const LA::Vector &b,
                                     const std::vector<double> &opening,
                                     const bool is_remembered)
{
  auto ordered = factor->in_order(b);
  eliminate(ordered, is_remembered);
  double *const last = ordered.data() + ordered.size() - cut.size();
  if (!opening.empty())
    {
      const auto resistance = complement->multiply(opening);
      for (unsigned int i = 0; i < cut.size(); ++i)
        last[i] -= resistance[i];
    }

  std::vector<double> q(basis.size(), 0.);
  for (unsigned int c = 0; c < basis.size(); ++c)
    for (const auto &[i, weight] : basis[c])
      q[c] += weight * last[i];
  reduced->solve(q);
  if (opening.empty())
    std::fill(last, last + cut.size(), 0.);
  else
    std::copy(opening.begin(), opening.end(), last);
  for (unsigned int c = 0; c < basis.size(); ++c)
    for (const auto &[i, weight] : basis[c])
      last[i] += weight * q[c];

  factor->recover(ordered);
  LA::Vector x = b;
  factor->from_order(ordered, x);
  base->distribute(x);
  return x;
}



template <int dim>
std::vector<double>
CondensedEquilibrium<dim>::take_opening(LA::Vector &prescribed) const
{
  std::vector<double> opening(cut.size());
  for (unsigned int i = 0; i < cut.size(); ++i)
    opening[i] = prescribed(cut[i]);
  if (std::all_of(
        opening.begin(), opening.end(), [](const double u) { return u == 0; }))
    return {};
  LA::Vector displacement = model.discretization.zero_vector();
  for (unsigned int i = 0; i < cut.size(); ++i)
    displacement(cut[i]) = opening[i];
  displacement.compress(VectorOperation::insert);
  base->distribute(displacement);
  prescribed -= displacement;
  return opening;
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
    return solve_for(condense(*base, rest), {}, false);
  };
  const double scale = mending.norm(mending.rest_of(prescribed));
  check_loads(scale);
  LA::Vector beyond_cut = prescribed;
  const auto opening    = take_opening(beyond_cut);
  LA::Vector x =
    solve_for(condense(*base, mending.rest_of(beyond_cut)), opening, true);
  x += beyond_cut;
  // Less than this is lost in the products of K x already.
  const double round_off =
    std::numeric_limits<double>::epsilon() * largest_entry * x.l2_norm();
  const LA::Vector rest =
    mend(x, std::max(scale * refined_above, round_off), mending);
  judge(x, rest, scale, mending);
  return x;
}



template <int dim>
void
CondensedEquilibrium<dim>::judge(const LA::Vector &x,
                                 const LA::Vector &rest,
                                 const double scale,
                                 const Mending &mending)
{
  // As long as the body yields little more than when it was last looked at, a
  // residual stands for about as much displacement as then.
  constexpr double much_more = 4;
  // Below this nobody needs to know more than that it is small.
  constexpr double small = 1e-9;
  const double error     = mending.norm(rest);
  const double largest   = x.linfty_norm();
  quality.residual       = scale > 0 ? error / scale : 0;
  quality.uncertainty    = largest > 0 ? error * per_residual / largest : 0;
  if (error > 0 && (largest > much_more * scale * known_compliance ||
                    !(quality.uncertainty <= small)))
    {
      const LA::Vector correction = mending.correction(rest);
      quality                     = quality_of(x, correction, error, scale);
      per_residual                = correction.linfty_norm() / error;
      known_compliance            = scale > 0 ? largest / scale : 0;
    }
  if (!is_accepted(error, scale, largest_entry, x))
    fail();
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
