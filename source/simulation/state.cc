#include <setsudan/simulation/state.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace Setsudan
{
using namespace dealii;

template <int dim>
BladeLoad<dim>
no_blade(const CutBody<dim> &body)
{
  return {body.model->discretization.zero_vector(), {}, {}};
}



namespace
{
/** The point of a row's front at a position along the edge: on the lines
 * between its nodes, or at its end. Nodes at one position count as one in
 * their middle. */
template <int dim>
Point<dim>
point_on_front(const std::vector<NodePair<dim>> &pairs,
               const Row &row,
               const double position)
{
  const auto &at         = row.positions;
  const double tolerance = 1e-10 * (at.back() - at.front());
  const auto middle      = [&](const double where) {
    Tensor<1, dim> sum;
    unsigned int n = 0;
    for (unsigned int i = 0; i < at.size(); ++i)
      if (std::abs(at[i] - where) <= tolerance)
        {
          sum += pairs[row.front[i]].position;
          ++n;
        }
    return Point<dim>(sum / n);
  };
  const double inside = std::clamp(position, at.front(), at.back());
  const double behind = *std::lower_bound(at.begin(), at.end(), inside);
  const double ahead =
    *std::prev(std::upper_bound(at.begin(), at.end(), inside));
  if (behind - ahead <= tolerance)
    return middle(ahead);
  const Tensor<1, dim> way = middle(behind) - middle(ahead);
  return middle(ahead) + (inside - ahead) / (behind - ahead) * way;
}
} // namespace


template <int dim>
BladeLoad<dim>
blade_on_row(const CutBody<dim> &body, const unsigned int row)
{
  const auto &pairs     = body.seam().pairs();
  const auto &front     = body.seam().rows()[row].front;
  const auto &direction = body.cut().edge.direction;
  BladeLoad<dim> blade  = no_blade(body);
  blade.row             = row;
  for (const auto &share : share_edge_loads(body.cut().edge_loads,
                                            body.seam().rows()[row].positions))
    for (unsigned int c = 0; c < dim; ++c)
      {
        // Half on each side, which is one node as long as the front is tied.
        const auto &pair = pairs[front[share.node]];
        for (const auto index : {pair.minus[c], pair.plus[c]})
          if (blade.nodal_forces.in_local_range(index))
            blade.nodal_forces(index) += share.force / 2 * direction[c];
      }
  blade.nodal_forces.compress(VectorOperation::add);
  for (const auto &load : body.cut().edge_loads)
    blade.forces.push_back(
      {point_on_front(pairs, body.seam().rows()[row], load.position),
       load.force * direction});
  return blade;
}



template <int dim>
State<dim>
rest_state(const CutBody<dim> &body)
{
  State<dim> state;
  for (LA::Vector *part :
       {&state.displacement, &state.opening, &state.forces, &state.internal})
    *part = body.model->discretization.zero_vector();
  return state;
}



template <int dim>
LA::Vector
prescribed_displacement(const CutBody<dim> &body, const State<dim> &state)
{
  LA::Vector displacement = body.model->prescribed;
  displacement += state.opening;
  return displacement;
}



template <int dim>
State<dim>
loaded_state(const Scene<dim> &scene,
             const CutBody<dim> &body,
             const BladeLoad<dim> &blade,
             const double load_factor)
{
  State<dim> state  = rest_state(body);
  state.load_factor = load_factor;
  state.forces      = body.model->loads;
  state.forces.add(load_factor, blade.nodal_forces);
  if (!body.seams.empty())
    state.opening = body.seam().opening(*body.model, scene.blade.thickness);
  return state;
}



template <int dim>
State<dim>
make_state(const Scene<dim> &scene,
           CutBody<dim> &body,
           const BladeLoad<dim> &blade,
           const double load_factor,
           const LA::Vector &displacement)
{
  State<dim> state   = loaded_state(scene, body, blade, load_factor);
  state.displacement = displacement;
  state.internal     = body.internal_forces(state.displacement);
  return state;
}



template <int dim>
double
unbalanced_part(const CutBody<dim> &body,
                const BladeLoad<dim> &blade,
                const State<dim> &state)
{
  LA::Vector forces = body.model->loads;
  forces.add(state.load_factor, blade.nodal_forces);
  forces -= state.internal;
  const double unbalanced = condense(body.constraints(), forces).l2_norm();
  double all              = state.internal.l2_norm();
  // Where nothing strains the body both are round-off of what it would resist
  // with.
  if (unbalanced > 1e-10 * all)
    all += Setsudan::internal_forces(*body.model,
                                     prescribed_displacement(body, state))
             .l2_norm();
  return all > 0 ? unbalanced / all : unbalanced;
}



template <int dim>
State<dim>
solve_state(const Scene<dim> &scene,
            CutBody<dim> &body,
            const BladeLoad<dim> &blade,
            const double load_factor,
            const LA::Vector &guess)
{
  State<dim> state       = loaded_state(scene, body, blade, load_factor);
  const auto equilibrium = body.equilibrium();
  state.displacement     = equilibrium->solve(
    state.forces, prescribed_displacement(body, state), guess);
  state.quality  = equilibrium->quality_of_last();
  state.internal = body.internal_forces(state.displacement);
  return state;
}



template BladeLoad<2>
no_blade(const CutBody<2> &);
template BladeLoad<2>
blade_on_row(const CutBody<2> &, const unsigned int);
template LA::Vector
prescribed_displacement(const CutBody<2> &, const State<2> &);
template State<2>
rest_state(const CutBody<2> &);
template State<2>
loaded_state(const Scene<2> &,
             const CutBody<2> &,
             const BladeLoad<2> &,
             const double);
template State<2>
make_state(const Scene<2> &,
           CutBody<2> &,
           const BladeLoad<2> &,
           const double,
           const LA::Vector &);
template double
unbalanced_part(const CutBody<2> &, const BladeLoad<2> &, const State<2> &);
template State<2>
solve_state(const Scene<2> &,
            CutBody<2> &,
            const BladeLoad<2> &,
            const double,
            const LA::Vector &);
template BladeLoad<3>
no_blade(const CutBody<3> &);
template BladeLoad<3>
blade_on_row(const CutBody<3> &, const unsigned int);
template LA::Vector
prescribed_displacement(const CutBody<3> &, const State<3> &);
template State<3>
rest_state(const CutBody<3> &);
template State<3>
loaded_state(const Scene<3> &,
             const CutBody<3> &,
             const BladeLoad<3> &,
             const double);
template State<3>
make_state(const Scene<3> &,
           CutBody<3> &,
           const BladeLoad<3> &,
           const double,
           const LA::Vector &);
template double
unbalanced_part(const CutBody<3> &, const BladeLoad<3> &, const State<3> &);
template State<3>
solve_state(const Scene<3> &,
            CutBody<3> &,
            const BladeLoad<3> &,
            const double,
            const LA::Vector &);
} // namespace Setsudan
