#include <setsudan/cut/front_stresses.h>
#include <setsudan/cut/process_zone.h>
#include <setsudan/elasticity/strain_recovery.h>

#include <map>

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
                  const Row &row,
                  const LA::Vector &displacement,
                  const RecoveredStress<dim> *recovered)
{
  std::map<types::global_dof_index, Tensor<1, 3>> normals;
  for (const unsigned int p : row.front)
    {
      const NodePair<dim> &pair = seam.pairs()[p];
      normals[pair.minus[0]]    = in_space(pair.normal);
      normals[pair.plus[0]]     = in_space(pair.normal);
    }

  const auto &discretization = model.discretization;
  StrainRecovery<dim> recovery(discretization,
                               model.materials,
                               node_points(discretization),
                               recovered ? update_values : update_default);
  FrontStresses stresses;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        std::vector<SymmetricTensor<2, 3>> of_cell;
        const auto nodes = discretization.node_indices(cell);
        for (unsigned int node = 0; node < nodes.size(); ++node)
          {
            const auto normal = normals.find(nodes[node][0]);
            if (normal == normals.end())
              continue;
            if (of_cell.empty())
              {
                recovery.reinit(cell, displacement);
                of_cell = stresses_of_cell(cell, recovery, recovered);
              }
            stresses.samples.push_back(
              {of_cell[node],
               model.materials.of_element(discretization.element(cell))
                 .shear_limit,
               normal->second});
          }
      }
  return stresses;
}
} // namespace


template <int dim>
FrontStresses
front_stresses(const ElasticModel<dim> &model,
               const Seam<dim> &seam,
               const Row &row,
               const YieldParameters &yield,
               const LA::Vector &displacement,
               const RecoveredStress<dim> *recovered)
{
  if (yield.criterion != YieldParameters::Criterion::mean_shear)
    return stresses_at_nodes(model, seam, row, displacement, recovered);
  std::vector<Point<dim>> centers;
  for (const unsigned int p : row.front)
    centers.push_back(seam.pairs()[p].position);
  return stresses_in_zones(
    model, centers, yield.process_zone, displacement, recovered);
}



template FrontStresses
front_stresses(const ElasticModel<2> &,
               const Seam<2> &,
               const Row &,
               const YieldParameters &,
               const LA::Vector &,
               const RecoveredStress<2> *);
template FrontStresses
front_stresses(const ElasticModel<3> &,
               const Seam<3> &,
               const Row &,
               const YieldParameters &,
               const LA::Vector &,
               const RecoveredStress<3> *);
} // namespace Setsudan
