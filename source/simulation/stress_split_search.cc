// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/state.h>
#include <setsudan/simulation/stress_split_search.h>

#include <cmath>

namespace Setsudan
{
template <int dim>
void
StressSplitSearch<dim>::begin(CutBody<dim> &of_body,
                              CutContact<dim> &of_contact,
                              const unsigned int of_row,
                              const ContactPath<dim> &of_path,
                              const BladeMotion &)
{
  body     = &of_body;
  contact  = &of_contact;
  row      = of_row;
  path     = &of_path;
  is_asked = false;
}



template <int dim>
LinearResponse
StressSplitSearch<dim>::response_at(const double travel) const
{
  const State<dim> state = contact->state(
    *path, row, travel, body->model().discretization.zero_vector());
  return {state.displacement, state.forces, lift_of(*body, state), 1};
}



template <int dim>
double
StressSplitSearch<dim>::factor_of_speed(const BladeMotion &motion,
                                        const double travel) const
{
  return this->rate_factor(body->length_of_rows(row, 1), motion, travel);
}



template <int dim>
std::optional<Split>
StressSplitSearch<dim>::split_before(const BladeMotion &motion,
                                     const double last,
                                     const LinearResponse &at_last) const
{
  const LinearResponse base = response_at(motion.travel);
  LinearResponse rest       = at_last;
  rest.displacement -= base.displacement;
  rest.forces -= base.forces;
  rest.lift -= base.lift;
  SolveQuality quality;
  const auto slow =
    this->scene.criterion->evaluate(*body, row, base, &rest, quality);
  const auto travel_at = [&](const double part) {
    return motion.travel + part * (last - motion.travel);
  };
  const auto at = [&](const double part) -> CuttingStress {
    CuttingStress stress = slow(part);
    stress.required *= factor_of_speed(motion, travel_at(part));
    return stress;
  };
  // In relation to what is required, which may be infinite at first.
  const auto found = find_yield_load(
    [&](const double part) -> CuttingStress {
      const CuttingStress stress = at(part);
      return stress.required > 0
               ? CuttingStress{stress.reached / stress.required, 1}
               : CuttingStress{0, 0};
    },
    1);
  if (!found.yields)
    return {};
  return Split{travel_at(found.load_factor), 1, at(found.load_factor)};
}



template <int dim>
std::optional<Split>
StressSplitSearch<dim>::first_split(const BladeMotion &motion, const double end)
{
  // Where nothing changes any more a body is sheared off long before.
  constexpr double far = 1000;
  const double last =
    std::isfinite(end) ? end : motion.travel + far * body->mesh().extent();
  SolveQuality quality;
  const auto stays = [&](const LinearResponse &response, const double travel) {
    CuttingStress stress = this->scene.criterion->evaluate(
      *body, row, response, nullptr, quality)(0);
    stress.required *= factor_of_speed(motion, travel);
    return !stress.yields();
  };
  const LinearResponse at_last = response_at(last);
  if (is_asked && stays(at_last, last))
    return {};
  is_asked = true;
  return split_before(motion, last, at_last);
}



template <int dim>
CuttingStress
StressSplitSearch<dim>::stress_at(const double travel) const
{
  SolveQuality quality;
  return this->scene.criterion->evaluate(
    *body, row, response_at(travel), nullptr, quality)(0);
}



template <int dim>
double
StressSplitSearch<dim>::surface_energy(CutBody<dim> &,
                                       const unsigned int,
                                       const unsigned int,
                                       const BladeMotion &,
                                       const double released) const
{
  return released;
}



template class StressSplitSearch<2>;
template class StressSplitSearch<3>;
} // namespace Setsudan
