#include <setsudan/solver/condensed/condensed_solver.h>
#include <setsudan/solver/linear/linear_solver.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The entries of a vector of one process. */
double *
entries(LA::Vector &vector)
{
  return vector.trilinos_vector()[0];
}



const double *
entries(const LA::Vector &vector)
{
  return vector.trilinos_vector()[0];
}



/** Two vectors of one process have the same entries. */
bool
are_equal(const LA::Vector &a, const LA::Vector &b)
{
  return a.size() == b.size() &&
         std::equal(entries(a), entries(a) + a.size(), entries(b));
}

} // namespace


template <int dim>
CondensedSolver<dim>::CondensedSolver(
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
  largest_entry = matrix.linfty_norm();
  condensation  = std::make_unique<StaticCondensation>(matrix, cut);
  reduced = std::make_unique<InterfaceSystem>(cut, condensation->stiffness());
}



template <int dim>
bool
CondensedSolver<dim>::set_constraints(
  std::shared_ptr<const Constraints> new_step)
{
  if (!reduced->set_constraints(*new_step))
    return false;
  step = std::move(new_step);
  return true;
}



template <int dim>
bool
CondensedSolver<dim>::append_stage(const Constraints &later)
{
  return reduced->append_stage(later);
}



template <int dim>
void
CondensedSolver<dim>::factorize_foreseen()
{
  reduced->factorize_foreseen();
}



template <int dim>
double
CondensedSolver<dim>::memory(const unsigned int n)
{
  // Both sides of the cut at once, each for itself, and what grows.
  return 8. * n * n * (1 + 0.5 + 1);
}



template <int dim>
StaticCondensation::Eliminated
CondensedSolver<dim>::forward_eliminate(const LA::Vector &loads,
                                        const bool is_remembered)
{
  if (!is_remembered)
    return condensation->forward_eliminate(loads);
  // From row to row the loads differ on the cut alone.
  LA::Vector off_cut = loads;
  double *const here = off_cut.trilinos_vector()[0];
  for (const unsigned int unknown : cut)
    here[unknown] = 0;
  if (remembered_loads.size() == 0 ||
      !std::equal(
        here, here + off_cut.size(), remembered_loads.trilinos_vector()[0]))
    {
      remembered       = condensation->forward_eliminate(off_cut);
      remembered_loads = off_cut;
    }
  StaticCondensation::Eliminated eliminated = remembered;
  for (unsigned int i = 0; i < cut.size(); ++i)
    eliminated.on_cut[i] += entries(loads)[cut[i]];
  return eliminated;
}



template <int dim>
LA::Vector
CondensedSolver<dim>::solve_for(const LA::Vector &b,
                                const std::vector<double> &opening,
                                const bool is_remembered)
{
  auto eliminated = forward_eliminate(b, is_remembered);
  if (!opening.empty())
    {
      const auto resistance = condensation->stiffness().multiply(opening);
      for (unsigned int i = 0; i < cut.size(); ++i)
        eliminated.on_cut[i] -= resistance[i];
    }

  auto of_cut = reduced->displacement(eliminated.on_cut.data());
  if (!opening.empty())
    for (unsigned int i = 0; i < cut.size(); ++i)
      of_cut[i] += opening[i];
  LA::Vector x = b;
  condensation->back_substitute(std::move(eliminated), of_cut, x);
  distribute(*base, x);
  return x;
}



template <int dim>
std::vector<double>
CondensedSolver<dim>::take_opening(LA::Vector &prescribed) const
{
  std::vector<double> opening(cut.size());
  for (unsigned int i = 0; i < cut.size(); ++i)
    opening[i] = entries(prescribed)[cut[i]];
  if (std::all_of(
        opening.begin(), opening.end(), [](const double u) { return u == 0; }))
    return {};
  LA::Vector displacement = model.discretization.zero_vector();
  for (unsigned int i = 0; i < cut.size(); ++i)
    entries(displacement)[cut[i]] = opening[i];
  distribute(*base, displacement);
  prescribed -= displacement;
  return opening;
}



template <int dim>
LA::Vector
CondensedSolver<dim>::loads_beside(const LA::Vector &forces,
                                   const LA::Vector &beyond_cut)
{
  if (!are_equal(beyond_cut, remembered_beyond))
    {
      remembered_beyond = beyond_cut;
      forces_of_beyond  = internal_forces(model, beyond_cut);
    }
  LA::Vector loads = forces;
  loads -= forces_of_beyond;
  return loads;
}



template <int dim>
LA::Vector
CondensedSolver<dim>::solve(const LA::Vector &forces,
                            const LA::Vector &prescribed,
                            const LA::Vector &)
{
  Refined mending;
  mending.residual_of = [&](const LA::Vector &displacement) {
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
  LA::Vector beyond_cut = prescribed;
  const auto opening    = take_opening(beyond_cut);
  const auto loads      = loads_beside(forces, beyond_cut);
  const double scale =
    mending.norm(opening.empty() ? loads : mending.residual_of(prescribed));
  check_loads(scale);
  LA::Vector x = solve_for(condense(*base, loads), opening, true);
  x += beyond_cut;
  // Less than this is lost in the products of K x already.
  const double round_off =
    std::numeric_limits<double>::epsilon() * largest_entry * x.l2_norm();
  const LA::Vector rest = iterative_refinement(
    x, std::max(scale * refinement_threshold, round_off), mending);
  judge(x, rest, scale, mending);
  return x;
}



template <int dim>
void
CondensedSolver<dim>::judge(const LA::Vector &x,
                            const LA::Vector &rest,
                            const double scale,
                            const Refined &mending)
{
  // As long as the body yields little more than when it was last looked at, a
  // residual stands for about as much displacement as then.
  constexpr double much_more = 4;
  // Below this nobody needs to know more than that it is small.
  constexpr double small = 1e-9;
  const double error     = mending.norm(rest);
  const double largest   = x.linfty_norm();
  quality.residual       = scale > 0 ? error / scale : 0;
  quality.estimated_relative_error =
    largest > 0 ? error * per_residual / largest : 0;
  if (error > 0 && (largest > much_more * scale * known_compliance ||
                    !(quality.estimated_relative_error <= small)))
    {
      const LA::Vector correction = mending.correction(rest);
      quality                     = quality_of(x, correction, error, scale);
      per_residual                = correction.linfty_norm() / error;
      known_compliance            = scale > 0 ? largest / scale : 0;
    }
  if (!converged(error, scale, largest_entry, x))
    fail();
}



template <int dim>
void
CondensedSolver<dim>::fail() const
{
  std::ostringstream message;
  message << "The condensed solve left a relative residual of "
          << quality.residual << ", which must not exceed " << failure_threshold
          << ". Set Division/Solve = every row anew.";
  throw SolverError(message.str());
}



template <int dim>
SolveQuality
CondensedSolver<dim>::quality_of_last() const
{
  return quality;
}



template class CondensedSolver<2>;
template class CondensedSolver<3>;
} // namespace Setsudan
