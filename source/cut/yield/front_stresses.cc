// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/yield/front_stresses.h>
#include <setsudan/cut/yield/process_zone.h>
#include <setsudan/mechanics/stress/stress_evaluator.h>

#include <memory>

namespace Setsudan
{
using namespace dealii;

namespace
{
template <int dim>
Tensor<1, 3>
in_space(const Tensor<1, dim> &vector)
{
  Tensor<1, 3> result;
  for (unsigned int d = 0; d < dim; ++d)
    result[d] = vector[d];
  return result;
}



/** The stresses at the front's nodes themselves. */
template <int dim>
FrontStresses
stresses_at_nodes(const ElasticModel<dim> &model,
                  const Seam<dim> &seam,
                  const SeamCells<dim> &cells,
                  const Row &row,
                  const LA::Vector &displacement,
                  const RecoveredStress<dim> *recovered)
{
  const auto &discretization = model.discretization;
  auto &evaluator            = cells.at_nodes();
  FrontStresses stresses;
  for (const auto &at : cells.at_front(row))
    {
      evaluator.reinit(at.cell, displacement);
      std::vector<SymmetricTensor<2, 3>> recovered_at;
      if (recovered)
        recovered_at = recovered->evaluate(at.cell, evaluator);
      const CutLimit &shear_limit =
        model.materials.of_element(discretization.element(at.cell)).shear_limit;
      for (unsigned int i = 0; i < at.nodes.size(); ++i)
        {
          const auto &normal = seam.pairs()[at.pairs[i]].normal;
          stresses.samples.push_back({recovered ? recovered_at[at.nodes[i]]
                                                : evaluator.stress(at.nodes[i]),
                                      shear_limit.across(normal),
                                      in_space(normal)});
        }
    }
  return stresses;
}



template <int dim>
std::vector<ProcessZone<dim>>
zones_at(const Seam<dim> &seam, const Row &row)
{
  std::vector<ProcessZone<dim>> zones;
  for (const unsigned int pair : row.front)
    zones.push_back({seam.pairs()[pair].position, seam.pairs()[pair].normal});
  return zones;
}
} // namespace


template <int dim>
FrontStresses
front_stresses(const ElasticModel<dim> &model,
               const Seam<dim> &seam,
               const SeamCells<dim> &cells,
               const Row &row,
               const YieldParameters &yield,
               const LA::Vector &displacement,
               const RecoveredStress<dim> *recovered)
{
  if (yield.criterion != YieldParameters::Criterion::mean_shear)
    return stresses_at_nodes(model, seam, cells, row, displacement, recovered);
  return stresses_in_zones(
    model, zones_at(seam, row), yield.process_zone, displacement, recovered);
}



template FrontStresses
front_stresses(const ElasticModel<2> &,
               const Seam<2> &,
               const SeamCells<2> &,
               const Row &,
               const YieldParameters &,
               const LA::Vector &,
               const RecoveredStress<2> *);
template FrontStresses
front_stresses(const ElasticModel<3> &,
               const Seam<3> &,
               const SeamCells<3> &,
               const Row &,
               const YieldParameters &,
               const LA::Vector &,
               const RecoveredStress<3> *);
} // namespace Setsudan
