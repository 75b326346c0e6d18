// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/cut/yield/cutting_stress.h>
#include <setsudan/material/material.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>

namespace Setsudan
{
using namespace dealii;

bool
CuttingStress::yields() const
{
  return reached > required || required == 0;
}



namespace
{
double
traction_measure(const FrontStress &sample)
{
  const Tensor<1, 3> traction = sample.stress * sample.normal;
  const double pull           = traction * sample.normal;
  const Tensor<1, 3> shear    = traction - pull * sample.normal;
  return std::hypot(std::max(pull, 0.), shear.norm());
}
} // namespace


double
stress_measure(const YieldParameters::Criterion criterion,
               const FrontStress &sample)
{
  using Criterion = YieldParameters::Criterion;
  switch (criterion)
    {
      case Criterion::maximum_shear:
      case Criterion::mean_shear:
        return maximum_shear(sample.stress);
      case Criterion::von_mises:
        return deviator(sample.stress).norm() / std::sqrt(2.);
      case Criterion::traction:
        return traction_measure(sample);
      case Criterion::energy_release:
        break;
    }
  AssertThrow(false, ExcMessage("This criterion is not one of stress."));
  return 0;
}



namespace
{
/** The measures and shear limits that are to be compared with each other: of
 * the samples, or of the means over zones, which all processes get. */
std::vector<std::pair<double, double>>
measures_and_limits(const YieldParameters::Criterion criterion,
                    const FrontStresses &stresses,
                    const MPI_Comm communicator)
{
  std::vector<std::pair<double, double>> result;
  if (stresses.n_zones == 0)
    {
      for (const auto &sample : stresses.samples)
        result.emplace_back(stress_measure(criterion, sample),
                            sample.shear_limit);
      return result;
    }
  const unsigned int n = stresses.n_zones;
  std::vector<double> sums(3 * n, 0.);
  const FrontStress *last = nullptr;
  double measure          = 0;
  for (const auto &sample : stresses.samples)
    {
      // A point lies in many zones, and has its samples one behind the other.
      if (!last || sample.stress != last->stress)
        measure = stress_measure(criterion, sample);
      last = &sample;
      sums[sample.zone] += sample.weight;
      sums[n + sample.zone] += sample.weight * measure;
      sums[2 * n + sample.zone] += sample.weight * sample.shear_limit;
    }
  Utilities::MPI::sum(sums, communicator, sums);
  for (unsigned int zone = 0; zone < n; ++zone)
    result.emplace_back(sums[n + zone] / sums[zone],
                        sums[2 * n + zone] / sums[zone]);
  return result;
}
} // namespace


CuttingStress
cutting_stress(const YieldParameters::Criterion criterion,
               const FrontStresses &stresses,
               const double sharpness,
               const MPI_Comm communicator)
{
  const auto measures = measures_and_limits(criterion, stresses, communicator);
  double largest      = 0;
  CuttingStress decisive;
  for (const auto &[measure, shear_limit] : measures)
    {
      const double ratio = measure / shear_limit;
      if (ratio > largest || (ratio == largest && measure >= decisive.reached))
        {
          largest  = ratio;
          decisive = {measure, requirement(shear_limit, sharpness)};
        }
    }
  // Of the processes with the largest ratio: they have the same material, or
  // it does not matter which.
  const double of_all = Utilities::MPI::max(largest, communicator);
  if (measures.empty() || largest < of_all)
    decisive = {0, 0};
  return {Utilities::MPI::max(decisive.reached, communicator),
          Utilities::MPI::max(decisive.required, communicator)};
}



double
requirement(const double limit, const double sharpness)
{
  return limit * (1 - sharpness);
}



FrontStresses
superpose(const FrontStresses &base,
          const FrontStresses &per_load,
          const double factor)
{
  AssertDimension(base.samples.size(), per_load.samples.size());
  FrontStresses stresses = base;
  for (unsigned int i = 0; i < stresses.samples.size(); ++i)
    stresses.samples[i].stress += factor * per_load.samples[i].stress;
  return stresses;
}



YieldFactor
find_yield_load(const std::function<CuttingStress(double)> &stress_at,
                const double max_load_factor)
{
  const CuttingStress at_rest = stress_at(0);
  if (at_rest.yields())
    return {0, at_rest, true};
  const CuttingStress at_most = stress_at(max_load_factor);
  if (!at_most.yields())
    return {max_load_factor, at_most, false};

  // Above 0 where the row yields; finite whatever the sizes.
  const auto excess = [&](const CuttingStress &stress) {
    return (stress.reached - stress.required) / at_most.reached;
  };
  boost::uintmax_t max_iterations = 200;
  const auto bracket              = boost::math::tools::toms748_solve(
    [&](const double factor) { return excess(stress_at(factor)); },
    0.,
    max_load_factor,
    excess(at_rest),
    excess(at_most),
    boost::math::tools::eps_tolerance<double>(52),
    max_iterations);
  return {bracket.second, stress_at(bracket.second), true};
}
} // namespace Setsudan
