// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/bounding_box.h>

#include <setsudan/space/rigid_modes.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
std::array<Tensor<1, dim>, n_rigid_modes<dim>>
rigid_modes(const Point<dim> &point,
            const Point<dim> &center,
            const double length)
{
  std::array<Tensor<1, dim>, n_rigid_modes<dim>> modes;
  for (unsigned int d = 0; d < dim; ++d)
    modes[d][d] = 1;
  const Tensor<1, dim> arm = (point - center) / length;
  unsigned int mode        = dim;
  for (unsigned int a = 0; a < dim; ++a)
    for (unsigned int b = a + 1; b < dim; ++b, ++mode)
      {
        modes[mode][a] = -arm[b];
        modes[mode][b] = arm[a];
      }
  return modes;
}



namespace
{
// Forms of order one of which less is left are held already.
constexpr double is_held_below = 1e-8;
} // namespace


template <int dim>
typename RigidBodyConstraints<dim>::Frame
RigidBodyConstraints<dim>::frame_of(const std::vector<Point<dim>> &points)
{
  const BoundingBox<dim> box(points);
  double length = 0;
  for (unsigned int d = 0; d < dim; ++d)
    length = std::max(length, box.side_length(d));
  return {box.center(), length / 2};
}



template <int dim>
RigidBodyConstraints<dim>::RigidBodyConstraints(
  const std::vector<Frame> &bodies)
  : frames(bodies)
{
}



template <int dim>
void
RigidBodyConstraints<dim>::add_displacement(const unsigned int body,
                                            const Point<dim> &point,
                                            const Tensor<1, dim> &direction,
                                            LinearForm &form) const
{
  const auto modes =
    rigid_modes(point, frames[body].center, frames[body].length);
  for (unsigned int m = 0; m < modes.size(); ++m)
    form(body * n_rigid_modes<dim> + m) += modes[m] * direction;
}



template <int dim>
typename RigidBodyConstraints<dim>::LinearForm
RigidBodyConstraints<dim>::zero() const
{
  return LinearForm(frames.size() * n_rigid_modes<dim>);
}



template <int dim>
typename RigidBodyConstraints<dim>::LinearForm
RigidBodyConstraints<dim>::unconstrained_part(const LinearForm &form) const
{
  LinearForm rest = form;
  // Twice, since once leaves round-off of the size of what was removed.
  for (unsigned int repeat = 0; repeat < 2; ++repeat)
    for (const LinearForm &held : basis)
      rest.add(-(rest * held), held);
  return rest;
}



template <int dim>
void
RigidBodyConstraints<dim>::hold(const LinearForm &form)
{
  LinearForm rest   = unconstrained_part(form);
  const double norm = rest.l2_norm();
  if (norm < is_held_below)
    return;
  rest /= norm;
  basis.push_back(rest);
}



template <int dim>
void
RigidBodyConstraints<dim>::hold(const unsigned int body,
                                const HeldPoint<dim> &point)
{
  for (unsigned int c = 0; c < dim && !holds_all(); ++c)
    if (point.components[c])
      {
        LinearForm form = zero();
        add_displacement(body,
                         point.position,
                         Tensor<1, dim>(Point<dim>::unit_vector(c)),
                         form);
        hold(form);
      }
}



template <int dim>
bool
RigidBodyConstraints<dim>::holds_all() const
{
  return basis.size() == frames.size() * n_rigid_modes<dim>;
}



template <int dim>
bool
RigidBodyConstraints<dim>::holds(const unsigned int body) const
{
  for (unsigned int m = 0; m < n_rigid_modes<dim>; ++m)
    {
      LinearForm motion                     = zero();
      motion(body * n_rigid_modes<dim> + m) = 1;
      if (unconstrained_part(motion).l2_norm() >= is_held_below)
        return false;
    }
  return true;
}



template <int dim>
std::vector<std::vector<PointComponent>>
RigidBodyConstraints<dim>::hold_all(
  const std::vector<std::vector<Point<dim>>> &points)
{
  std::vector<std::vector<PointComponent>> hold_of_body(frames.size());
  while (!holds_all())
    {
      LinearForm best    = zero();
      double best_norm   = 0;
      unsigned int where = 0;
      PointComponent best_component;
      for (unsigned int body = 0; body < points.size(); ++body)
        for (unsigned int p = 0; p < points[body].size(); ++p)
          for (unsigned int c = 0; c < dim; ++c)
            {
              LinearForm form = zero();
              add_displacement(body,
                               points[body][p],
                               Tensor<1, dim>(Point<dim>::unit_vector(c)),
                               form);
              const double norm = unconstrained_part(form).l2_norm();
              // A clear winner only, so that round-off does not choose.
              if (norm > best_norm * (1 + 1e-10))
                {
                  best           = form;
                  best_norm      = norm;
                  where          = body;
                  best_component = {p, c};
                }
            }
      if (best_norm < is_held_below)
        break;
      hold(best);
      hold_of_body[where].push_back(best_component);
    }
  return hold_of_body;
}



template <int dim>
std::vector<PointComponent>
find_minimal_hold(const std::vector<HeldPoint<dim>> &held,
                  const std::vector<Point<dim>> &candidates)
{
  RigidBodyConstraints<dim> motions(
    {RigidBodyConstraints<dim>::frame_of(candidates)});
  for (const auto &point : held)
    motions.hold(0, point);
  return motions.hold_all({candidates}).front();
}



template class RigidBodyConstraints<2>;
template class RigidBodyConstraints<3>;
template std::array<Tensor<1, 2>, 3>
rigid_modes(const Point<2> &, const Point<2> &, const double);
template std::array<Tensor<1, 3>, 6>
rigid_modes(const Point<3> &, const Point<3> &, const double);
template std::vector<PointComponent>
find_minimal_hold(const std::vector<HeldPoint<2>> &,
                  const std::vector<Point<2>> &);
template std::vector<PointComponent>
find_minimal_hold(const std::vector<HeldPoint<3>> &,
                  const std::vector<Point<3>> &);
} // namespace Setsudan
