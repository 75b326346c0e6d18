// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/record/frame_facts.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Vectors as VTK has them, of three components each. */
template <int dim>
VtuArray
vectors(const std::string &name, const std::vector<Tensor<1, dim>> &list)
{
  std::vector<double> values;
  for (const auto &vector : list)
    for (unsigned int c = 0; c < 3; ++c)
      values.push_back(c < dim ? vector[c % dim] : 0.);
  return {name, 3, values, {"X", "Y", "Z"}};
}

/** @param label the name of the component: a unit, or what the number means. */
template <typename Number>
VtuArray
number(const std::string &name,
       const Number value,
       const std::string &label = "")
{
  return {name,
          1,
          std::vector<Number>{value},
          label.empty() ? std::vector<std::string>()
                        : std::vector<std::string>{label}};
}

/** The number of an event's name, for readers that do not show it. */
std::int32_t
number_of_event(const std::string &name)
{
  return name == "rest" ? 0 : name == "divide" ? 2 : 1;
}

/** The blade on its row: where its forces act in the body at rest, and the axes
 * of the cut. */
template <int dim>
void
add_blade(const CutBody<dim> &body,
          const BladeLoad<dim> &blade,
          const double load_factor,
          FrameFacts &facts)
{
  const auto &pairs = body.seam().pairs();
  Tensor<1, dim> normal;
  for (const unsigned int pair : body.seam().rows()[*blade.row].front)
    {
      for (const auto *side : {&pairs[pair].minus, &pairs[pair].plus})
        facts.front.push_back((*side)[0]);
      normal += pairs[pair].normal;
    }
  std::sort(facts.front.begin(), facts.front.end());
  std::vector<Tensor<1, dim>> points, forces;
  for (const auto &force : blade.forces)
    {
      points.push_back(force.point);
      forces.push_back(load_factor * force.force);
    }
  facts.of_state.push_back(vectors("blade_points", points));
  facts.of_state.push_back(vectors("blade_forces", forces));
  facts.of_state.push_back(
    vectors<dim>("blade_direction", {body.cut().edge.direction}));
  // On a closed front the normals cancel.
  if (normal.norm() > 1e-6)
    facts.of_state.push_back(
      vectors<dim>("cut_normal", {normal / normal.norm()}));
}
} // namespace



template <int dim>
FrameFacts
frame_facts(const CutBody<dim> &body,
            const BladeLoad<dim> &blade,
            const Event &event,
            const double time)
{
  FrameFacts facts;
  facts.of_state = {
    number("TimeValue", time),
    number("event", number_of_event(event.name), event.name),
    number("cut", std::int32_t(event.cut)),
    number("row", std::int32_t(event.row)),
    number("depth", event.depth, body.scene().length_unit),
    number("load_factor", event.load_factor),
    number("blade_force", event.blade_force, body.scene().force_unit)};
  if (blade.row)
    add_blade(body, blade, event.load_factor, facts);
  return facts;
}



template FrameFacts
frame_facts(const CutBody<2> &,
            const BladeLoad<2> &,
            const Event &,
            const double);
template FrameFacts
frame_facts(const CutBody<3> &,
            const BladeLoad<3> &,
            const Event &,
            const double);
} // namespace Setsudan
