// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/energy_split_search.h>
#include <setsudan/simulation/stress_split_search.h>

#include <limits>

namespace Setsudan
{
template <int dim>
std::unique_ptr<SplitSearch<dim>>
SplitSearch<dim>::make(const Scene<dim> &scene)
{
  if (scene.yield.criterion == YieldParameters::Criterion::energy_release)
    return std::make_unique<EnergySplitSearch<dim>>(scene);
  return std::make_unique<StressSplitSearch<dim>>(scene);
}



template <int dim>
SplitSearch<dim>::SplitSearch(const Scene<dim> &scene)
  : scene(scene)
{
}



template <int dim>
unsigned int
SplitSearch<dim>::n_looked_ahead(CutBody<dim> &, const unsigned int) const
{
  return 1;
}



template <int dim>
double
SplitSearch<dim>::end() const
{
  return std::numeric_limits<double>::infinity();
}



template <int dim>
void
SplitSearch<dim>::cross(const double)
{
}



template <int dim>
double
SplitSearch<dim>::rate_factor(const double length,
                              const BladeMotion &motion,
                              const double travel) const
{
  if (!scene.rate.is_active())
    return 1.;
  double time = motion.time - motion.time_of_split;
  if (travel > motion.travel)
    time +=
      (travel - motion.travel) / scene.blade.path.speed_to(motion.n_stops);
  return scene.rate.factor(length / time);
}



template class SplitSearch<2>;
template class SplitSearch<3>;
} // namespace Setsudan
