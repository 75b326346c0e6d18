#include <setsudan/output/shown_stress.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
ShownStress<dim>::ShownStress(const ElasticModel<dim> &model,
                              const LA::Vector &displacement)
  : model(model)
{
  if (!model.materials.any_is_mixed())
    return;
  const auto &discretization = model.discretization;
  dilatations.resize(discretization.triangulation.n_active_cells());
  Dilatation<dim> dilatation(discretization);
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      dilatations[cell->active_cell_index()] = dilatation(cell, displacement);
}



template <int dim>
std::vector<std::string>
ShownStress<dim>::names()
{
  std::vector<std::string> names(dim * dim, "stress");
  names.push_back("maximum_shear");
  names.push_back("stress_zz");
  return names;
}



template <int dim>
SymmetricTensor<2, 3>
ShownStress<dim>::stress_at(const Cell &cell,
                            const Point<dim> &point,
                            const Tensor<2, dim> &gradient) const
{
  const Material &material =
    model.materials.of_element(model.discretization.element(cell));
  const auto strain = symmetrize(gradient);
  return material.is_mixed
           ? material.hooke.stress(
               strain, dilatations[cell->active_cell_index()](point))
           : material.hooke.stress(strain);
}



template <int dim>
double
ShownStress<dim>::shear(const SymmetricTensor<2, 3> &stress)
{
  const auto principal = eigenvalues(stress);
  return (principal[0] - principal[2]) / 2;
}



template class ShownStress<2>;
template class ShownStress<3>;
} // namespace Setsudan
