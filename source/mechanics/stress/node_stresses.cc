#include <setsudan/mechanics/stress/node_stresses.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
NodeStresses<dim>::NodeStresses(const Discretization<dim> &discretization,
                                const MaterialParameters<dim> &materials)
  : discretization(discretization)
  , materials(materials)
{
  const auto &element = discretization.fe.base_element(0);
  for (const auto &node : discretization.nodes())
    {
      gradients.emplace_back();
      for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
        gradients.back().push_back(element.shape_grad(i, node));
    }
  if (materials.any_is_mixed())
    dilatation = std::make_unique<Dilatation<dim>>(discretization);
}



template <int dim>
std::vector<SymmetricTensor<2, 3>>
NodeStresses<dim>::operator()(const Cell &cell,
                              const std::vector<unsigned int> &nodes,
                              const LA::Vector &displacement) const
{
  const auto positions = discretization.node_positions(cell);
  const auto indices   = discretization.node_indices(cell);
  std::vector<Tensor<1, dim>> displacements(indices.size());
  for (unsigned int i = 0; i < indices.size(); ++i)
    for (unsigned int c = 0; c < dim; ++c)
      displacements[i][c] = displacement(indices[i][c]);
  const Material &material = materials.of_element(discretization.element(cell));
  LinearFunction<dim> dilatation_of_cell;
  if (material.is_mixed)
    dilatation_of_cell = (*dilatation)(cell, displacement);

  std::vector<SymmetricTensor<2, 3>> stresses;
  for (const unsigned int node : nodes)
    {
      Tensor<2, dim> of_positions, of_displacements;
      for (unsigned int i = 0; i < positions.size(); ++i)
        {
          const auto &gradient = gradients[node][i];
          of_positions += outer_product(positions[i], gradient);
          of_displacements += outer_product(displacements[i], gradient);
        }
      const auto strain = symmetrize(of_displacements * invert(of_positions));
      stresses.push_back(
        material.is_mixed
          ? material.hooke.stress(strain, dilatation_of_cell(positions[node]))
          : material.hooke.stress(strain));
    }
  return stresses;
}



template class NodeStresses<2>;
template class NodeStresses<3>;
} // namespace Setsudan
