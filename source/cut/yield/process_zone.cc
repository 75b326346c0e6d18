// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/cut/yield/process_zone.h>
#include <setsudan/mechanics/stress/stress_evaluator.h>
#include <setsudan/parameters/exceptions.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace Setsudan
{
using namespace dealii;

namespace
{
// A cell is integrated by at most so many copies of Gauss's rule along each
// axis.
constexpr unsigned int most_copies = 8;


/** The recoveries with repeated rules, as they are asked for. */
template <int dim>
class RepeatedRules
{
public:
  explicit RepeatedRules(const ElasticModel<dim> &model)
    : model(model)
  {
  }

  /** The rule for a cell of this size: points are not farther apart than a
   * sixth of the radius, if that can be. */
  StressEvaluator<dim> &
  for_cell(const double size, const double radius)
  {
    const unsigned int n_copies =
      std::clamp<double>(std::ceil(2 * size / radius), 1, most_copies);
    auto &rule = rules[n_copies];
    if (!rule)
      rule = std::make_unique<StressEvaluator<dim>>(
        model.discretization,
        model.materials,
        QIterated<dim>(QGauss<1>(3), n_copies),
        &model.internal);
    return *rule;
  }

private:
  const ElasticModel<dim> &model;
  std::map<unsigned int, std::unique_ptr<StressEvaluator<dim>>> rules;
};



/** The zones that a cell may reach into. */
template <int dim>
std::vector<unsigned int>
zones_near(const typename Discretization<dim>::Cell &cell,
           const std::vector<ProcessZone<dim>> &zones,
           const double radius)
{
  std::vector<unsigned int> near;
  // Curved sides bulge by less than the diameter.
  const double reach = radius + cell->diameter();
  for (unsigned int z = 0; z < zones.size(); ++z)
    if (cell->center().distance(zones[z].center) < reach)
      near.push_back(z);
  return near;
}



void
check_zones(const FrontStresses &stresses, const MPI_Comm communicator)
{
  std::vector<double> weights(stresses.n_zones, 0.);
  for (const auto &sample : stresses.samples)
    weights[sample.zone] += sample.weight;
  Utilities::MPI::sum(weights, communicator, weights);
  if (std::any_of(weights.begin(), weights.end(), [](const double weight) {
        return !(weight > 0);
      }))
    throw CutError(
      "Yield/Process zone is too small for the elements at the front, which "
      "have no integration point in it. Refine the body near the cut, or take "
      "a zone of at least an eighth of an element.");
}
} // namespace


template <int dim>
FrontStresses
stresses_in_zones(const ElasticModel<dim> &model,
                  const std::vector<ProcessZone<dim>> &zones,
                  const double radius,
                  const LA::Vector &displacement,
                  const RecoveredStress<dim> *recovered)
{
  const auto &discretization = model.discretization;
  RepeatedRules<dim> rules(model);
  FrontStresses stresses;
  stresses.n_zones = zones.size();
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    {
      if (!cell->is_locally_owned())
        continue;
      const auto near = zones_near<dim>(cell, zones, radius);
      if (near.empty())
        continue;
      auto &recovery = rules.for_cell(cell->diameter(), radius);
      recovery.reinit(cell, displacement);
      const auto of_cell =
        recovered ? recovered->evaluate(cell, recovery) : recovery.stresses();
      const CutLimit &shear_limit =
        model.materials.of_element(discretization.element(cell)).shear_limit;
      std::vector<double> limits;
      for (const unsigned int zone : near)
        limits.push_back(shear_limit.across(zones[zone].normal));
      for (unsigned int p = 0; p < recovery.n_points(); ++p)
        for (unsigned int z = 0; z < near.size(); ++z)
          {
            const double r =
              recovery.point(p).distance(zones[near[z]].center) / radius;
            if (r < 1)
              stresses.samples.push_back(
                {of_cell[p],
                 limits[z],
                 {},
                 near[z],
                 recovery.volume(p) * std::pow(1 - r * r, 2)});
          }
    }
  check_zones(stresses, discretization.communicator);
  return stresses;
}



template FrontStresses
stresses_in_zones(const ElasticModel<2> &,
                  const std::vector<ProcessZone<2>> &,
                  const double,
                  const LA::Vector &,
                  const RecoveredStress<2> *);
template FrontStresses
stresses_in_zones(const ElasticModel<3> &,
                  const std::vector<ProcessZone<3>> &,
                  const double,
                  const LA::Vector &,
                  const RecoveredStress<3> *);
} // namespace Setsudan
