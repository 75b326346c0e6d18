#include <deal.II/base/bounding_box.h>

#include <setsudan/elasticity/rigid_modes.h>

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
/** An orthonormal basis of rigid motions that grows as components are held. */
template <int dim>
class HeldMotions
{
public:
  using Motion = Tensor<1, n_rigid_modes<dim>>;

  HeldMotions(const Point<dim> &center, const double length)
    : center(center)
    , length(length)
  {
  }

  /** How much holding this component would stop beyond what is held: from 0
   * to about 1. */
  Motion
  unheld_part(const Point<dim> &point, const unsigned int component) const
  {
    const auto modes = rigid_modes(point, center, length);
    Motion motion;
    for (unsigned int m = 0; m < modes.size(); ++m)
      motion[m] = modes[m][component];
    // Twice, since once leaves round-off of the size of what was removed.
    for (unsigned int repeat = 0; repeat < 2; ++repeat)
      for (const Motion &held : basis)
        motion -= (motion * held) * held;
    return motion;
  }

  void
  hold(const Motion &motion)
  {
    basis.push_back(motion / motion.norm());
  }

  bool
  holds_all() const
  {
    return basis.size() == n_rigid_modes<dim>;
  }

private:
  const Point<dim> center;
  const double length;
  std::vector<Motion> basis;
};


/** Hold, one by one, the component that stops most, until nothing is left
 * to be stopped. */
template <int dim>
std::vector<PointComponent>
hold_greedily(const std::vector<HeldPoint<dim>> &points,
              HeldMotions<dim> &held_motions)
{
  std::vector<PointComponent> hold;
  while (!held_motions.holds_all())
    {
      typename HeldMotions<dim>::Motion best;
      PointComponent best_component;
      for (unsigned int p = 0; p < points.size(); ++p)
        for (unsigned int c = 0; c < dim; ++c)
          if (points[p].components[c])
            {
              const auto motion =
                held_motions.unheld_part(points[p].position, c);
              // A clear winner only, so that round-off does not choose.
              if (motion.norm() > best.norm() * (1 + 1e-10))
                {
                  best           = motion;
                  best_component = {p, c};
                }
            }
      if (best.norm() < 1e-8)
        break;
      held_motions.hold(best);
      hold.push_back(best_component);
    }
  return hold;
}
} // namespace


template <int dim>
std::vector<PointComponent>
find_minimal_hold(const std::vector<HeldPoint<dim>> &held,
                  const std::vector<Point<dim>> &candidates)
{
  const BoundingBox<dim> box(candidates);
  double length = 0;
  for (unsigned int d = 0; d < dim; ++d)
    length = std::max(length, box.side_length(d));
  HeldMotions<dim> held_motions(box.center(), length / 2);
  hold_greedily(held, held_motions);
  std::vector<HeldPoint<dim>> free;
  for (const auto &candidate : candidates)
    free.push_back({candidate, std::bitset<dim>().set()});
  return hold_greedily(free, held_motions);
}



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
