// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/output/frames/blade_surface.h>
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
  const auto &front = body.seam().rows()[*blade.row].front;
  Tensor<1, dim> normal, middle, sum;
  for (const unsigned int pair : front)
    {
      for (const auto *side : {&pairs[pair].minus, &pairs[pair].plus})
        facts.front.push_back((*side)[0]);
      normal += pairs[pair].normal;
      middle += pairs[pair].position;
    }
  std::sort(facts.front.begin(), facts.front.end());
  std::vector<Tensor<1, dim>> points, forces;
  double magnitudes = 0;
  for (const auto &force : blade.forces)
    {
      points.push_back(force.point);
      forces.push_back(load_factor * force.force);
      sum += forces.back();
      magnitudes += forces.back().norm();
    }
  // Contact has forces at all nodes that touch. Where flanks are parallel they
  // cancel.
  constexpr double round_off = 1e-12;
  if (body.scene().blade.travels)
    {
      if (sum.norm() <= round_off * magnitudes)
        sum = Tensor<1, dim>();
      points = {middle / static_cast<double>(front.size())};
      forces = {sum};
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
            const State<dim> &state,
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
  if (state.blade.row)
    add_blade(body, state.blade, event.load_factor, facts);
  return facts;
}



namespace
{
/** Where the edge is on its way, and how long it is: as long as the cut. */
template <int dim>
BladePlace<dim>
place_of_blade(const CutBody<dim> &body, const BladeMotion &motion)
{
  const auto &edge  = body.cut().edge;
  const auto &pairs = body.seam().pairs();
  BladePlace<dim> place;
  place.direction = edge.direction;
  for (const auto &pair : pairs)
    place.normal += pair.normal;
  place.normal /= place.normal.norm();
  Tensor<1, dim> along;
  if constexpr (dim == 3)
    along = cross_product_3d(place.normal, place.direction);
  const Point<dim> entry =
    pairs[body.seam().rows().front().front.front()].position;
  std::array<double, 2> ends{{0., 0.}};
  for (const auto &pair : pairs)
    {
      const double position = (pair.position - entry) * along;
      ends = {{std::min(ends[0], position), std::max(ends[1], position)}};
    }
  const double beyond = (ends[1] - ends[0]) / 10;
  std::vector<double> positions{0.};
  if constexpr (dim == 3)
    positions = {ends[0] - beyond, ends[1] + beyond};
  for (const auto &point : edge.points)
    {
      const double position =
        (point.position - entry[edge.axis]) / along[edge.axis];
      if (position > ends[0] && position < ends[1])
        positions.push_back(position);
    }
  std::sort(positions.begin(), positions.end());
  const double first = travels_of_pairs(pairs, edge)[0];
  for (const double position : positions)
    {
      const Point<dim> at = entry + position * along;
      place.edge.push_back(
        at + (motion.travel - (edge.travel(at) - first)) * edge.direction +
        motion.shift * edge.normal);
    }
  place.length = motion.travel + body.mesh().extent() / 5;
  return place;
}
} // namespace


template <int dim>
std::shared_ptr<const VtuGrid>
blade_of_state(const CutBody<dim> &body, const State<dim> &state)
{
  if (!state.motion || !state.blade.row)
    return nullptr;
  return std::make_shared<const VtuGrid>(blade_surface(
    body.scene().blade.profile, place_of_blade(body, *state.motion)));
}



template std::shared_ptr<const VtuGrid>
blade_of_state(const CutBody<2> &, const State<2> &);
template std::shared_ptr<const VtuGrid>
blade_of_state(const CutBody<3> &, const State<3> &);
template FrameFacts
frame_facts(const CutBody<2> &, const State<2> &, const Event &, const double);
template FrameFacts
frame_facts(const CutBody<3> &, const State<3> &, const Event &, const double);
} // namespace Setsudan
