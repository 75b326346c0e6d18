#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/lac/full_matrix.h>

#include <setsudan/elasticity/recovered_stress.h>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The components of a stress that can differ from 0, in the order in which
 * they are kept. */
template <int dim>
std::vector<TableIndices<2>>
components()
{
  if constexpr (dim == 2)
    return {{0, 0}, {1, 1}, {2, 2}, {0, 1}};
  else
    return {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}};
}



/** Row i has the weights of the Gauss points' values at the i-th node: those of
 * the multilinear function through them. */
template <int dim>
FullMatrix<double>
extrapolation()
{
  const FE_DGQArbitraryNodes<dim> functions(QGauss<1>(2));
  FullMatrix<double> weights(n_element_nodes<dim>, functions.n_dofs_per_cell());
  for (unsigned int node = 0; node < weights.m(); ++node)
    for (unsigned int g = 0; g < weights.n(); ++g)
      weights(node, g) =
        functions.shape_value(g, unit_point_of_node<dim>(node));
  return weights;
}
} // namespace


template <int dim>
RecoveredStress<dim>::RecoveredStress(const ElasticModel<dim> &model,
                                      const LA::Vector &displacement)
  : model(model)
  , fields(model.materials.n_materials())
{
  for (unsigned int material = 0; material < fields.size(); ++material)
    add_cells_of_material(material, displacement);
}



template <int dim>
void
RecoveredStress<dim>::add_cells_of_material(const unsigned int material,
                                            const LA::Vector &displacement)
{
  static const auto kept     = components<dim>();
  static const auto weights  = extrapolation<dim>();
  const auto &discretization = model.discretization;
  // In the lexicographic order of the functions of extrapolation().
  StrainRecovery<dim> recovery(discretization, model.materials, QGauss<dim>(2));
  std::array<LA::Vector, n_vectors> sums = {
    {discretization.zero_vector(), discretization.zero_vector()}};
  LA::Vector n_cells = discretization.zero_vector();
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned() &&
        model.materials.number(discretization.element(cell)) == material)
      {
        recovery.reinit(cell, displacement);
        const auto nodes = discretization.node_indices(cell);
        for (unsigned int node = 0; node < nodes.size(); ++node)
          {
            SymmetricTensor<2, 3> stress;
            for (unsigned int g = 0; g < recovery.n_points(); ++g)
              stress += weights(node, g) * recovery.stress(g);
            for (unsigned int k = 0; k < kept.size(); ++k)
              sums[k / dim](nodes[node][k % dim]) += stress[kept[k]];
            for (unsigned int c = 0; c < dim; ++c)
              n_cells(nodes[node][c]) += 1;
          }
      }
  n_cells.compress(VectorOperation::add);
  for (unsigned int v = 0; v < n_vectors; ++v)
    {
      sums[v].compress(VectorOperation::add);
      for (const auto index : discretization.owned)
        if (n_cells(index) > 0)
          sums[v](index) /= n_cells(index);
      sums[v].compress(VectorOperation::insert);
      model.hanging.distribute(sums[v]);
      fields[material][v] = discretization.with_ghosts(sums[v]);
    }
}



template <int dim>
std::vector<SymmetricTensor<2, 3>>
RecoveredStress<dim>::evaluate(const Cell &cell,
                               const FEValues<dim> &fe_values) const
{
  static const auto kept = components<dim>();
  const auto &of_material =
    fields[model.materials.number(model.discretization.element(cell))];
  std::vector<SymmetricTensor<2, 3>> stresses(fe_values.n_quadrature_points);
  std::vector<Tensor<1, dim>> values(stresses.size());
  for (unsigned int v = 0; v < n_vectors; ++v)
    {
      fe_values[FEValuesExtractors::Vector(0)].get_function_values(
        of_material[v], values);
      for (unsigned int q = 0; q < stresses.size(); ++q)
        for (unsigned int c = 0; c < dim && v * dim + c < kept.size(); ++c)
          stresses[q][kept[v * dim + c]] = values[q][c];
    }
  return stresses;
}



template <int dim>
std::vector<SymmetricTensor<2, 3>>
stresses_of_cell(const typename Discretization<dim>::Cell &cell,
                 const StrainRecovery<dim> &recovery,
                 const RecoveredStress<dim> *recovered)
{
  if (recovered)
    return recovered->evaluate(cell, recovery.values());
  std::vector<SymmetricTensor<2, 3>> stresses;
  for (unsigned int p = 0; p < recovery.n_points(); ++p)
    stresses.push_back(recovery.stress(p));
  return stresses;
}



template std::vector<SymmetricTensor<2, 3>>
stresses_of_cell(const typename Discretization<2>::Cell &,
                 const StrainRecovery<2> &,
                 const RecoveredStress<2> *);
template std::vector<SymmetricTensor<2, 3>>
stresses_of_cell(const typename Discretization<3>::Cell &,
                 const StrainRecovery<3> &,
                 const RecoveredStress<3> *);
template class RecoveredStress<2>;
template class RecoveredStress<3>;
} // namespace Setsudan
