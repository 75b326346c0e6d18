// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/vector.h>

#include <setsudan/mechanics/dilatation.h>
#include <setsudan/mechanics/stiffness.h>
#include <setsudan/mechanics/strain_and_stress.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
ElementStiffness<dim>::ElementStiffness(
  const Discretization<dim> &discretization,
  const MaterialParameters<dim> &materials)
  : discretization(discretization)
  , materials(materials)
  , fe_values(
      discretization.mapping(),
      discretization.fe,
      QGauss<dim>(discretization.n_gauss_points()),
      update_gradients | update_JxW_values |
        (materials.any_is_mixed() ? update_quadrature_points : update_default))
  , matrix(discretization.fe.n_dofs_per_cell())
  , shapes(discretization)
{
}



template <int dim>
const FullMatrix<double> &
ElementStiffness<dim>::operator()(const Cell &cell) const
{
  const unsigned int element  = discretization.element(cell);
  const unsigned int material = materials.number(element);
  if (!shapes.is_last(cell) || material != last_material)
    {
      integrate(cell, materials.of_element(element));
      last_material = material;
    }
  return matrix;
}



template <int dim>
unsigned int
ElementStiffness<dim>::n_integrations() const
{
  return integrations;
}



template <int dim>
void
ElementStiffness<dim>::integrate(const Cell &cell,
                                 const Material &material) const
{
  const unsigned int n = matrix.m();
  fe_values.reinit(cell);
  matrix = 0;
  if (const auto *const stiffness = material.law->anisotropic_stiffness())
    add_lower_half(*stiffness);
  else
    add_lower_half(material.at_rest, material.is_mixed);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < i; ++j)
      matrix(j, i) = matrix(i, j);
  ++integrations;
}



template <int dim>
void
ElementStiffness<dim>::add_lower_half(const Hooke &material,
                                      const bool is_mixed) const
{
  const FEValuesExtractors::Vector displacement(0);
  const unsigned int n = matrix.m();
  std::vector<SymmetricTensor<2, dim>> strain(n);
  const auto dilatation    = dilatations(is_mixed);
  const auto &[lambda, mu] = material;
  for (const unsigned int q : fe_values.quadrature_point_indices())
    {
      for (unsigned int i = 0; i < n; ++i)
        strain[i] = fe_values[displacement].symmetric_gradient(i, q);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          matrix(i, j) += (lambda * dilatation[i][q] * dilatation[j][q] +
                           2 * mu * (strain[i] * strain[j])) *
                          fe_values.JxW(q);
    }
}



template <int dim>
void
ElementStiffness<dim>::add_lower_half(
  const SymmetricTensor<4, 3> &stiffness) const
{
  const FEValuesExtractors::Vector displacement(0);
  const unsigned int n = matrix.m();
  std::vector<SymmetricTensor<2, 3>> strain(n);
  for (const unsigned int q : fe_values.quadrature_point_indices())
    {
      for (unsigned int i = 0; i < n; ++i)
        strain[i] =
          symmetrize(in_space(fe_values[displacement].gradient(i, q)));
      for (unsigned int i = 0; i < n; ++i)
        {
          const auto stress = stiffness * strain[i] * fe_values.JxW(q);
          for (unsigned int j = 0; j <= i; ++j)
            matrix(i, j) += stress * strain[j];
        }
    }
}



template <int dim>
std::vector<std::vector<double>>
ElementStiffness<dim>::dilatations(const bool are_projected) const
{
  const FEValuesExtractors::Vector displacement(0);
  const auto points = fe_values.quadrature_point_indices();
  std::vector<std::vector<double>> values(
    matrix.m(), std::vector<double>(fe_values.n_quadrature_points));
  for (unsigned int i = 0; i < values.size(); ++i)
    for (const unsigned int q : points)
      values[i][q] = fe_values[displacement].divergence(i, q);
  if (are_projected)
    {
      const auto fit = dilatation_fit(discretization.type, fe_values);
      for (auto &of_function : values)
        {
          const auto projected = fit(of_function);
          for (const unsigned int q : points)
            of_function[q] = projected(fe_values.quadrature_point(q));
        }
    }
  return values;
}



template <int dim>
LA::Vector
assemble_forces(
  const Discretization<dim> &discretization,
  const std::function<const dealii::Vector<double> *(
    const typename Discretization<dim>::Cell &,
    const std::vector<types::global_dof_index> &)> &forces_of_cell)
{
  std::vector<types::global_dof_index> indices(
    discretization.fe.n_dofs_per_cell());
  LA::Vector forces = discretization.zero_vector();
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        cell->get_dof_indices(indices);
        if (const auto *const of_cell = forces_of_cell(cell, indices))
          forces.add(indices, *of_cell);
      }
  forces.compress(VectorOperation::add);
  return forces;
}



template <int dim>
LA::Vector
internal_forces(const Discretization<dim> &discretization,
                const ElementStiffness<dim> &stiffness,
                const LA::Vector &displacement)
{
  const unsigned int n = discretization.fe.n_dofs_per_cell();
  dealii::Vector<double> cell_displacement(n), cell_forces(n);
  return assemble_forces<dim>(
    discretization, [&](const auto &cell, const auto &indices) {
      displacement.extract_subvector_to(
        indices.begin(), indices.end(), cell_displacement.begin());
      stiffness(cell).vmult(cell_forces, cell_displacement);
      return &cell_forces;
    });
}



template <int dim>
void
assemble_matrix(const Discretization<dim> &discretization,
                const std::function<const FullMatrix<double> &(
                  const typename Discretization<dim>::Cell &)> &matrix_of_cell,
                const AffineConstraints<double> &constraints,
                LA::SparseMatrix &matrix)
{
  const IndexSet &owned       = discretization.owned;
  const MPI_Comm communicator = discretization.communicator;

  if (matrix.m() == discretization.dof_handler.n_dofs())
    matrix = 0;
  else
    {
      // The pattern has a row for all that a constraint of this process names:
      // with fewer, entries are lost without a word.
      const IndexSet &rows = constraints.get_local_lines();
      DynamicSparsityPattern pattern(rows);
      DoFTools::make_sparsity_pattern(
        discretization.dof_handler,
        pattern,
        constraints,
        false,
        discretization.triangulation.locally_owned_subdomain());
      SparsityTools::distribute_sparsity_pattern(
        pattern, owned, communicator, rows);
      matrix.reinit(owned, owned, pattern, communicator);
    }

  std::vector<types::global_dof_index> indices(
    discretization.fe.n_dofs_per_cell());
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        cell->get_dof_indices(indices);
        constraints.distribute_local_to_global(
          matrix_of_cell(cell), indices, matrix);
      }
  matrix.compress(VectorOperation::add);
}



template <int dim>
void
assemble_stiffness(const Discretization<dim> &discretization,
                   const ElementStiffness<dim> &stiffness,
                   const AffineConstraints<double> &constraints,
                   LA::SparseMatrix &matrix)
{
  assemble_matrix<dim>(
    discretization,
    [&](const auto &cell) -> const FullMatrix<double> & {
      return stiffness(cell);
    },
    constraints,
    matrix);
}



template class ElementStiffness<2>;
template class ElementStiffness<3>;
template LA::Vector
assemble_forces(const Discretization<2> &,
                const std::function<const dealii::Vector<double> *(
                  const Discretization<2>::Cell &,
                  const std::vector<types::global_dof_index> &)> &);
template LA::Vector
internal_forces(const Discretization<2> &,
                const ElementStiffness<2> &,
                const LA::Vector &);
template LA::Vector
assemble_forces(const Discretization<3> &,
                const std::function<const dealii::Vector<double> *(
                  const Discretization<3>::Cell &,
                  const std::vector<types::global_dof_index> &)> &);
template LA::Vector
internal_forces(const Discretization<3> &,
                const ElementStiffness<3> &,
                const LA::Vector &);
template void
assemble_matrix(const Discretization<2> &,
                const std::function<const FullMatrix<double> &(
                  const Discretization<2>::Cell &)> &,
                const AffineConstraints<double> &,
                LA::SparseMatrix &);
template void
assemble_stiffness(const Discretization<2> &,
                   const ElementStiffness<2> &,
                   const AffineConstraints<double> &,
                   LA::SparseMatrix &);
template void
assemble_matrix(const Discretization<3> &,
                const std::function<const FullMatrix<double> &(
                  const Discretization<3>::Cell &)> &,
                const AffineConstraints<double> &,
                LA::SparseMatrix &);
template void
assemble_stiffness(const Discretization<3> &,
                   const ElementStiffness<3> &,
                   const AffineConstraints<double> &,
                   LA::SparseMatrix &);
} // namespace Setsudan
