// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mechanics/stress/deformation_extremes.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/simulation/contact_way.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The most steps in a part of a way. */
constexpr unsigned int most_steps = 25;
} // namespace


template <int dim>
NonlinearContact<dim>::Way::Way(const NonlinearContact &contact,
                                Stage &stage,
                                const BladeProfile &of_blade,
                                const BladeMotion &motion,
                                const Equilibrium &from)
  : contact(contact)
  , stage(stage)
  , model(contact.body.model())
  , of_blade(of_blade)
  , motion(motion)
  , begin_of_travel(from.travel)
  , earlier(from.path)
  , lacking(model.loads)
  , lacking_displacement(model.lift)
  , size_of_forces(from.internal.forces.l2_norm())
{
  // Of rows that split, contact is another one.
  if (from.path && from.n_split == stage.n_split)
    lacking += contact.on_body(from.path->forces(from.travel));
  lacking -= from.internal.forces;
  lacking_displacement -= from.displacement;
  for (const auto unknown : model.discretization.owned)
    if (!model.supported.is_element(unknown))
      lacking_displacement(unknown) = 0;
  lacking_displacement.compress(VectorOperation::insert);
  constexpr double round_off = 1e-14;
  if (lacking_displacement.linfty_norm() <=
      round_off * model.lift.linfty_norm())
    lacking_displacement = 0;
}



template <int dim>
LA::Vector
NonlinearContact<dim>::Way::loads_at(const double part) const
{
  LA::Vector loads = model.loads;
  loads.add(part - 1, lacking);
  return loads;
}



template <int dim>
std::optional<typename NonlinearContact<dim>::Way::Iterate>
NonlinearContact<dim>::Way::step(const Iterate &about,
                                 const double part,
                                 const LA::Vector &prescribed)
{
  constexpr double smallest = 1e-3, largest = 10, factor = 4;
  constexpr unsigned int most_tries = 10;
  const auto go_towards = [&](Iterate &&to, const unsigned int most) {
    return search(about, std::move(to), part, prescribed, most);
  };
  // So near to an equilibrium a tangent serves twice.
  constexpr double near = 1e-6;
  if (is_exact && is_new && about.relative_residual < near)
    {
      is_new = false;
      return go_towards(solve_tangent(about, part, prescribed), most_tries);
    }
  is_exact = is_new = true;
  try
    {
      stage.tangent.linearize(about.displacement);
      const unsigned int n_negative = stage.tangent.n_negative();
      Iterate next                  = solve_tangent(about, part, prescribed);
      // One that contact holds may have several equilibria: only the one that
      // is near is that of the body.
      if (next.path->is_stable(n_negative))
        if (auto found =
              go_towards(std::move(next), n_negative == 0 ? most_tries : 1);
            found || n_negative == 0)
          return found;
    }
  catch (const NotDefiniteError &)
    {
      // Not even then.
    }
  catch (const SolverError &)
    {
      if (stage.tangent.n_negative() == 0)
        throw;
      // No contact holds it.
    }
  // What ties have held upright may be nowhere near an equilibrium.
  is_exact = false;
  for (double shift = smallest; shift < largest; shift *= factor)
    try
      {
        stage.tangent.linearize(about.displacement, shift);
        if (stage.tangent.n_negative() == 0)
          return go_towards(solve_tangent(about, part, prescribed), most_tries);
      }
    catch (const NotDefiniteError &)
      {
      }
  throw NotDefiniteError("The tangent is far from being positive definite.");
}



template <int dim>
typename NonlinearContact<dim>::Way::Iterate
NonlinearContact<dim>::Way::solve_tangent(const Iterate &about,
                                          const double part,
                                          const LA::Vector &prescribed) const
{
  const auto &all     = contact.basis.vectors();
  LA::Vector residual = loads_at(part);
  residual -= about.internal.forces;
  LA::Vector begin = about.displacement;
  begin += prescribed;
  if (prescribed.linfty_norm() > 0)
    residual -= tangent_times(model, about.displacement, prescribed);
  if (!stage.springs.empty())
    residual -= spring_forces(stage.springs, begin);
  LA::Vector without_contact = begin;
  without_contact += stage.tangent.increment(residual);

  const unsigned int n     = all.size();
  const auto products_here = stage.tangent.products();
  LAPACKFullMatrix<double> products(n);
  for (unsigned int i = 0; i < stage.vectors.size(); ++i)
    for (unsigned int j = 0; j < stage.vectors.size(); ++j)
      products(stage.vectors[i], stage.vectors[j]) = products_here(i, j);
  UntouchedBody untouched{{Vector<double>(n), Vector<double>(n)}, {}};
  const auto measured = work_of(all, without_contact);
  std::copy(
    measured.begin(), measured.end(), untouched.displacements.constant.begin());

  BladeMotion moved = motion;
  moved.travel      = travel_at(part);
  Iterate next;
  next.path           = contact.make_path(of_blade,
                                stage.n_split,
                                stage.n_ahead,
                                products,
                                untouched,
                                moved,
                                earlier.get());
  next.contact_forces = contact.on_body(next.path->forces(moved.travel));
  residual += next.contact_forces;
  if (!stage.springs.empty())
    {
      next.foundation_forces =
        contact.on_body(next.path->foundation_forces(moved.travel));
      residual += next.foundation_forces;
    }
  next.displacement = begin;
  next.displacement += stage.tangent.increment(residual);
  return next;
}



template <int dim>
void
NonlinearContact<dim>::Way::evaluate(Iterate &iterate, const double part) const
{
  iterate.internal = evaluate_laws(model, iterate.displacement);
  if (iterate.internal.energy.is_finite())
    measure(iterate, part);
}



template <int dim>
void
NonlinearContact<dim>::Way::measure(Iterate &iterate, const double part) const
{
  LA::Vector residual = loads_at(part);
  iterate.potential   = iterate.internal.energy.potential +
                      iterate.internal.potential_of_pressure -
                      residual * iterate.displacement;
  const double scale = std::max({residual.l2_norm(),
                                 iterate.contact_forces.l2_norm(),
                                 iterate.internal.forces.l2_norm(),
                                 size_of_forces});
  residual += iterate.contact_forces;
  residual -= iterate.internal.forces;
  if (!stage.springs.empty())
    {
      // What is left of the springs.
      residual += iterate.foundation_forces;
      residual -= spring_forces(stage.springs, iterate.displacement);
    }
  iterate.residual = condense(stage.constraints, residual).l2_norm();
  iterate.relative_residual =
    scale > 0 ? iterate.residual / scale : iterate.residual;
}



template <int dim>
std::optional<typename NonlinearContact<dim>::Way::Iterate>
NonlinearContact<dim>::Way::search(const Iterate &from,
                                   Iterate &&to,
                                   const double part,
                                   const LA::Vector &prescribed,
                                   const unsigned int most_tries) const
{
  // Supports that move do work, too.
  if (prescribed.linfty_norm() > 0)
    {
      evaluate(to, part);
      return to.internal.energy.is_finite() ? std::optional<Iterate>(to)
                                            : std::nullopt;
    }
  // Of the fall that the slope promises, what a step must bring.
  constexpr double least_share = 1e-4;
  LA::Vector step              = to.displacement;
  step -= from.displacement;
  LA::Vector residual = loads_at(part);
  residual -= from.internal.forces;
  // An exact penalty beside the energy, while conditions are not fulfilled.
  const double penalty =
    2 * to.path->work_to_fulfil(
          work_of(contact.basis.vectors(), from.displacement), travel_at(part));
  const double fall = step * residual + penalty;
  double length     = 1;
  for (unsigned int i = 0; i < most_tries; ++i, length /= 2)
    {
      Iterate tried      = to;
      tried.displacement = from.displacement;
      tried.displacement.add(length, step);
      evaluate(tried, part);
      if (!tried.internal.energy.is_finite())
        continue;
      const bool falls = tried.potential - from.potential <=
                         length * (penalty - least_share * fall);
      // Forces of friction have no energy, and round-off has none to tell.
      if (falls || tried.residual < from.residual ||
          tried.residual <= stage.tangent.round_off())
        return tried;
    }
  return {};
}



template <int dim>
std::optional<ContactEquilibrium<dim>>
NonlinearContact<dim>::Way::go(const Equilibrium &from,
                               const double behind,
                               const double part)
{
  LA::Vector prescribed = lacking_displacement;
  prescribed *= part - behind;
  is_new = false;
  Iterate before;
  before.displacement = from.displacement;
  before.path         = from.path;
  before.internal     = from.internal;
  // That of the blade and the ties is not there yet.
  before.contact_forces    = model.discretization.zero_vector();
  before.foundation_forces = before.contact_forces;
  measure(before, part);
  for (unsigned int n = 1; n <= most_steps; ++n)
    {
      auto found = step(before, part, prescribed);
      if (!found)
        return {};
      prescribed              = 0;
      Iterate next            = std::move(*found);
      const bool is_round_off = (next.relative_residual < failure_threshold ||
                                 next.residual <= stage.tangent.round_off()) &&
                                (n == 1 || next.residual > before.residual / 4);
      if (is_exact &&
          (next.relative_residual <= contact.body.scene().solver.tolerance ||
           is_round_off))
        {
          if (!is_attainable(model, from.displacement, next.displacement))
            return {};
          quality.residual    = next.relative_residual;
          quality.force_scale = size_of_forces;
          const double energy = next.internal.energy.total() +
                                next.internal.potential_of_pressure -
                                model.loads * next.displacement;
          return Equilibrium{stage.n_split,
                             travel_at(part),
                             std::move(next.displacement),
                             std::move(next.path),
                             std::move(next.internal),
                             energy,
                             quality,
                             n};
        }
      before = std::move(next);
    }
  return {};
}



template class NonlinearContact<2>::Way;
template class NonlinearContact<3>::Way;
} // namespace Setsudan
