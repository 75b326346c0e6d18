// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/yield/yield_criterion.h>
#include <setsudan/mechanics/assumed_state.h>

#include <algorithm>
#include <array>
#include <utility>

namespace Setsudan
{
namespace
{
/** The largest stress of a kind at the front, or in process zones there. */
template <int dim>
class StressCriterion : public YieldCriterion<dim>
{
public:
  StressCriterion(const YieldParameters &parameters,
                  const double smallest_shear_limit,
                  const double sharpness)
    : parameters(parameters)
    , sharpness(sharpness)
    , smallest(requirement(smallest_shear_limit, sharpness))
  {
  }

  std::function<CuttingStress(double)>
  evaluate(YieldingBody<dim> &body,
           const unsigned int row,
           const LinearResponse &base,
           const LinearResponse *per_load,
           SolveQuality &) const override
  {
    const auto &discretization = body.model().discretization;
    const auto stresses        = [&](const LinearResponse &response) {
      return stresses_of(
        body, row, discretization.with_ghosts(response.displacement), nullptr);
    };
    const FrontStresses at_base = stresses(base);
    const FrontStresses by_load =
      per_load != nullptr ? stresses(*per_load) : FrontStresses();
    return [this, at_base, by_load, communicator = discretization.communicator](
             const double factor) {
      return cutting_stress(parameters.criterion,
                            factor == 0 ? at_base
                                        : superpose(at_base, by_load, factor),
                            sharpness,
                            communicator);
    };
  }

  double
  reached_by(const YieldingBody<dim> &body,
             const unsigned int row,
             const LA::Vector &displacement,
             const RecoveredStress<dim> &recovered) const override
  {
    return cutting_stress(parameters.criterion,
                          stresses_of(body, row, displacement, &recovered),
                          sharpness,
                          body.model().discretization.communicator)
      .reached;
  }

  double
  smallest_requirement() const override
  {
    return smallest;
  }

private:
  FrontStresses
  stresses_of(const YieldingBody<dim> &body,
              const unsigned int row,
              const LA::Vector &displacement,
              const RecoveredStress<dim> *recovered) const
  {
    return front_stresses(body.model(),
                          body.seam(),
                          body.seam_cells(),
                          body.seam().rows()[row],
                          parameters,
                          displacement,
                          recovered);
  }

  const YieldParameters parameters;
  const double sharpness;
  const double smallest;
};



/** The energy that splitting a row sets free, for each new area. */
template <int dim>
class EnergyRelease : public YieldCriterion<dim>
{
public:
  EnergyRelease(const double smallest_toughness, const double sharpness)
    : sharpness(sharpness)
    , smallest(requirement(smallest_toughness, sharpness))
  {
  }

  std::function<CuttingStress(double)>
  evaluate(YieldingBody<dim> &body,
           const unsigned int row,
           const LinearResponse &base,
           const LinearResponse *per_load,
           SolveQuality &quality) const override
  {
    const auto solver          = body.solver_without(row);
    const BladeAdvance advance = body.advance_of_blade(row);
    const RowArea opened       = body.area_of_row(row);
    const double required      = requirement(opened.energy, sharpness);
    if (!body.model().is_linear())
      {
        Assert(per_load == nullptr, dealii::ExcInternalError());
        const double energy =
          exact_release(body.model(), *solver, advance, base, quality);
        return
          [=](const double) { return of_area(energy, required, opened.area); };
      }
    const auto released = [&](const LinearResponse &response) {
      return release(body.model(), *solver, advance, response, quality);
    };
    const auto follows = [&](const LinearResponse &response) {
      return advance.change * response.displacement;
    };
    const Release at_base = released(base);
    const double moved    = follows(base) + advance.work;
    std::array<double, 3> energy{
      {at_base.displacement * at_base.internal / 2 + base.blade_factor * moved,
       0.,
       0.}};
    if (per_load != nullptr)
      {
        const Release by_load    = released(*per_load);
        const double moved_by_it = follows(*per_load);
        energy[1]                = at_base.displacement * by_load.internal +
                    base.blade_factor * moved_by_it +
                    per_load->blade_factor * moved;
        energy[2] = by_load.displacement * by_load.internal / 2 +
                    per_load->blade_factor * moved_by_it;
      }
    return [=](const double factor) {
      return of_area(largest_up_to(factor, energy), required, opened.area);
    };
  }

  double
  reached_by(const YieldingBody<dim> &,
             const unsigned int,
             const LA::Vector &,
             const RecoveredStress<dim> &) const override
  {
    return 0;
  }

  double
  smallest_requirement() const override
  {
    return smallest;
  }

private:
  static CuttingStress
  of_area(const double energy, const double required, const double area)
  {
    // Behind the last nodes there is nothing to open.
    if (area == 0)
      return {0, 0};
    return {energy / area, required / area};
  }

  /** The equilibrium without a row's ties, with the blade's load on the next
   * row, and the forces under which it is. */
  static std::pair<Solution, LA::Vector>
  solve_released(TangentSolver &solver,
                 const BladeAdvance &advance,
                 const LinearResponse &tied,
                 SolveQuality &quality)
  {
    LA::Vector forces = tied.forces;
    forces.add(tied.blade_factor, advance.change);
    Solution released = solver.solve(forces, tied.lift, tied.displacement);
    quality           = combine(quality, released.quality);
    return {std::move(released), std::move(forces)};
  }

  /** The energy that a body which is not linear sets free. */
  static double
  exact_release(const ElasticModel<dim> &model,
                TangentSolver &solver,
                const BladeAdvance &advance,
                const LinearResponse &tied,
                SolveQuality &quality)
  {
    const AssumedState<dim> assumed(model, tied.displacement);
    const auto [released, forces] =
      solve_released(solver, advance, tied, quality);
    const auto potential = [&](const LA::Vector &displacement,
                               const LA::Vector &under) {
      const InternalForces of_laws = evaluate_laws(model, displacement);
      return of_laws.energy.potential + of_laws.potential_of_pressure -
             under * displacement;
    };
    return potential(tied.displacement, tied.forces) -
           potential(released.displacement, forces) +
           tied.blade_factor * advance.work;
  }

  /** The largest value between 0 and a factor of a quadratic function of the
   * factor: a load that rises has passed it. */
  static double
  largest_up_to(const double factor, const std::array<double, 3> &c)
  {
    const auto value = [&](const double f) {
      return c[0] + f * (c[1] + f * c[2]);
    };
    const double vertex = c[2] < 0 ? -c[1] / (2 * c[2]) : factor;
    return std::max(
      {value(0), value(factor), value(std::clamp(vertex, 0., factor))});
  }

  /** The displacement d by which the body gives way when a row's ties are taken
   * off and the blade follows the front, and K d. */
  struct Release
  {
    LA::Vector displacement;
    LA::Vector internal;
  };

  /**
   * Before and after, the body is in the minimum of its potential energy, once
   * over a smaller set and under the forces f, once under f + c, where the
   * blade's load has moved on: E(before) - E(after) = d . K d / 2 + c . u, with
   * u the displacement before. To that comes the blade's work on its way. All
   * are quadratic in the load, and d is linear in it.
   */
  static Release
  release(const ElasticModel<dim> &model,
          TangentSolver &solver,
          const BladeAdvance &advance,
          const LinearResponse &tied,
          SolveQuality &quality)
  {
    LA::Vector change =
      solve_released(solver, advance, tied, quality).first.displacement;
    change -= tied.displacement;
    return {change, internal_forces(model, change)};
  }

  const double sharpness;
  const double smallest;
};
} // namespace


template <int dim>
std::unique_ptr<const YieldCriterion<dim>>
YieldCriterion<dim>::make(const YieldParameters &parameters,
                          const MaterialParameters<dim> &materials,
                          const double sharpness)
{
  if (parameters.criterion == YieldParameters::Criterion::energy_release)
    return std::make_unique<EnergyRelease<dim>>(materials.smallest_toughness(),
                                                sharpness);
  return std::make_unique<StressCriterion<dim>>(
    parameters, materials.smallest_shear_limit(), sharpness);
}



template class YieldCriterion<2>;
template class YieldCriterion<3>;
} // namespace Setsudan
