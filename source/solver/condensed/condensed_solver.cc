// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/condensed/condensed_solver.h>
#include <setsudan/solver/linear/linear_solver.h>
#include <setsudan/space/first_process.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The entries of a vector that one process has. */
const double *
entries(const LA::Vector &vector)
{
  return vector.trilinos_vector()[0];
}



/** Whether two vectors have the same entries. */
bool
are_equal(const LA::Vector &a, const LA::Vector &b)
{
  if (a.size() != b.size())
    return false;
  const bool here =
    std::equal(entries(a), entries(a) + a.locally_owned_size(), entries(b));
  return Utilities::MPI::min<int>(here, a.get_mpi_communicator()) == 1;
}
} // namespace


template <int dim>
CondensedSolver<dim>::CondensedSolver(
  const ElasticModel<dim> &model,
  std::shared_ptr<const Constraints> base_constraints,
  const IndexSet &cut_unknowns,
  std::vector<UnknownForces> vectors_of_foundation)
  : model(model)
  , base(std::move(base_constraints))
  , foundation(std::move(vectors_of_foundation))
  , communicator(model.discretization.communicator)
  , is_first(Utilities::MPI::this_mpi_process(communicator) == 0)
{
  // A process knows the constraints of its own unknowns.
  LA::Vector constrained = model.discretization.zero_vector();
  for (const auto unknown : model.discretization.owned)
    if (base->is_constrained(unknown))
      constrained(unknown) = 1;
  constrained.compress(VectorOperation::insert);
  const LA::Vector all_constrained = gather(constrained);
  if (is_first)
    for (const auto unknown : cut_unknowns)
      if (entries(all_constrained)[unknown] == 0)
        cut.push_back(unknown);
  cut = of_first_process(communicator, [&] { return cut; });
  condense_at_rest();
}



template <int dim>
UnknownForces
CondensedSolver<dim>::placed_on_cut(
  const UnknownForces &vector,
  const std::function<void(unsigned int, double)> &beside) const
{
  UnknownForces placed;
  for (const auto &[unknown, factor] : vector)
    {
      const auto place = std::lower_bound(cut.begin(), cut.end(), unknown);
      if (place != cut.end() && *place == unknown)
        placed.emplace_back(place - cut.begin(), factor);
      else if (beside)
        beside(unknown, factor);
    }
  return placed;
}



template <int dim>
bool
CondensedSolver<dim>::set_constraints(
  std::shared_ptr<const Constraints> new_constraints)
{
  const bool fits = of_first_process(
    communicator, [&] { return interface->set_constraints(*new_constraints); });
  if (fits)
    constraints = std::move(new_constraints);
  return fits;
}



template <int dim>
bool
CondensedSolver<dim>::append_stage(const Constraints &stage)
{
  return of_first_process(communicator,
                          [&] { return interface->append_stage(stage); });
}



template <int dim>
void
CondensedSolver<dim>::factorize_stages()
{
  if (is_first)
    interface->factorize_stages();
}



template <int dim>
unsigned int
CondensedSolver<dim>::n_free() const
{
  return of_first_process(communicator, [&] { return interface->n_free(); });
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
typename CondensedSolver<dim>::InterfaceState
CondensedSolver<dim>::solve_interface(const LA::Vector &b,
                                      const std::vector<double> &opening,
                                      const bool is_remembered)
{
  InterfaceState state;
  const LA::Vector loads = gather(b);
  if (!is_first)
    return state;
  state.loads = forward_eliminate(loads, is_remembered);
  auto forces = state.loads.on_cut;
  if (!opening.empty())
    {
      const auto resistance = condensation->stiffness().multiply(opening);
      for (unsigned int i = 0; i < cut.size(); ++i)
        forces[i] -= resistance[i];
    }
  state.displacement = interface->displacement(forces.data());
  if (!opening.empty())
    for (unsigned int i = 0; i < cut.size(); ++i)
      state.displacement[i] += opening[i];
  return state;
}



template <int dim>
LA::Vector
CondensedSolver<dim>::recover(InterfaceState &&state) const
{
  LA::Vector x     = model.discretization.zero_vector();
  LA::Vector whole = gather(x);
  if (is_first)
    condensation->back_substitute(
      std::move(state.loads), state.displacement, whole);
  scatter(whole, x);
  distribute(*base, x);
  return x;
}



template <int dim>
std::vector<double>
CondensedSolver<dim>::take_opening(LA::Vector &lift) const
{
  const auto opening = on_cut(lift);
  if (std::all_of(
        opening.begin(), opening.end(), [](const double u) { return u == 0; }))
    return {};
  LA::Vector displacement = model.discretization.zero_vector();
  for (unsigned int i = 0; i < cut.size(); ++i)
    if (model.discretization.owned.is_element(cut[i]))
      displacement(cut[i]) = opening[i];
  displacement.compress(VectorOperation::insert);
  distribute(*base, displacement);
  lift -= displacement;
  return opening;
}



template <int dim>
std::vector<double>
CondensedSolver<dim>::on_cut(const LA::Vector &vector) const
{
  const LA::Vector whole = gather(vector);
  return of_first_process(communicator, [&] {
    std::vector<double> values;
    for (const unsigned int unknown : cut)
      values.push_back(entries(whole)[unknown]);
    return values;
  });
}



template <int dim>
LA::Vector
CondensedSolver<dim>::residual_of_lift(const LA::Vector &forces,
                                       const LA::Vector &lift_off_cut)
{
  if (!are_equal(lift_off_cut, remembered_lift))
    {
      remembered_lift = lift_off_cut;
      forces_of_lift  = resisting_forces(lift_off_cut);
    }
  LA::Vector residual = forces;
  residual -= forces_of_lift;
  return residual;
}



template <int dim>
Solution
CondensedSolver<dim>::solve(const LA::Vector &forces,
                            const LA::Vector &lift,
                            const LA::Vector &)
{
  RefinedSystem system;
  system.residual_of = [&](const LA::Vector &displacement) {
    LA::Vector residual = forces;
    residual -= resisting_forces(displacement);
    return residual;
  };
  system.norm = [&](const LA::Vector &residual) {
    return condense(*constraints, residual).l2_norm();
  };
  system.correction = [&](const LA::Vector &residual) {
    return correction(condense(*base, residual));
  };
  LA::Vector lift_off_cut = lift;
  const auto opening      = take_opening(lift_off_cut);
  const auto loads        = residual_of_lift(forces, lift_off_cut);
  const double scale =
    system.norm(opening.empty() ? loads : system.residual_of(lift));
  check_loads(scale);

  Solution solution;
  LA::Vector &x = solution.displacement;
  x = recover(solve_interface(condense(*base, loads), opening, true));
  x += lift_off_cut;
  // Less than this is lost in the products of K x already.
  const double round_off =
    std::numeric_limits<double>::epsilon() * largest_entry * x.l2_norm();
  const LA::Vector residual = iterative_refinement(
    x, std::max(scale * refinement_threshold, round_off), system);
  solution.internal = forces;
  solution.internal -= residual;
  if (!foundation.empty())
    solution.internal -= spring_forces(foundation, x);
  solution.quality = check_quality(x, residual, scale, system);
  return solution;
}



template <int dim>
LA::Vector
CondensedSolver<dim>::resisting_forces(const LA::Vector &displacement) const
{
  LA::Vector forces = internal_forces(model, displacement);
  if (!foundation.empty())
    forces += spring_forces(foundation, displacement);
  return forces;
}



template <int dim>
LA::Vector
CondensedSolver<dim>::correction(const LA::Vector &forces)
{
  return recover(solve_interface(forces, {}, false));
}



template <int dim>
SolveQuality
CondensedSolver<dim>::check_quality(const LA::Vector &x,
                                    const LA::Vector &residual,
                                    const double scale,
                                    const RefinedSystem &system)
{
  // As long as the body yields little more than when it was last looked at, a
  // residual stands for about as much displacement as then.
  constexpr double much_more = 4;
  // Below this nobody needs to know more than that it is small.
  constexpr double small = 1e-9;
  const double norm      = system.norm(residual);
  const double largest   = x.linfty_norm();
  SolveQuality quality;
  quality.residual = scale > 0 ? norm / scale : 0;
  quality.estimated_relative_error =
    largest > 0 ? norm * per_residual / largest : 0;
  if (norm > 0 && (largest > much_more * scale * known_compliance ||
                   !(quality.estimated_relative_error <= small)))
    {
      const LA::Vector correction = system.correction(residual);
      quality                     = quality_of(x, correction, norm, scale);
      per_residual                = correction.linfty_norm() / norm;
      known_compliance            = scale > 0 ? largest / scale : 0;
    }
  if (!converged(norm, scale, largest_entry, x))
    {
      std::ostringstream message;
      message << "The condensed solve left a relative residual of "
              << quality.residual << ", which must not exceed "
              << failure_threshold << ". Set Division/Solve = every row anew.";
      throw SolverError(message.str());
    }
  return quality;
}



template class CondensedSolver<2>;
template class CondensedSolver<3>;
} // namespace Setsudan
