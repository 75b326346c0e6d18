// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/vector.h>

#include <setsudan/mechanics/loads.h>

namespace Setsudan
{
using namespace dealii;

namespace
{
template <int dim>
using Index = typename Discretization<dim>::Index;

/** The forces of a density (per volume or per area) on the nodes of a cell. */
template <int dim>
void
add_density(const FEValuesBase<dim> &fe_values,
            const std::function<Tensor<1, dim>(unsigned int)> &density,
            dealii::Vector<double> &cell_forces)
{
  const FEValuesExtractors::Vector displacement(0);
  for (const unsigned int q : fe_values.quadrature_point_indices())
    {
      const Tensor<1, dim> force = density(q) * fe_values.JxW(q);
      for (unsigned int i = 0; i < cell_forces.size(); ++i)
        cell_forces(i) += fe_values[displacement].value(i, q) * force;
    }
}



/** Add body force, pressures and tractions. */
template <int dim>
void
add_distributed_loads(const Discretization<dim> &discretization,
                      const LoadParameters<dim> &loads,
                      const bool pressure_follows,
                      LA::Vector &forces)
{
  FEValues<dim> fe_values(discretization.mapping(),
                          discretization.fe,
                          QGauss<dim>(discretization.n_gauss_points()),
                          update_values | update_JxW_values);
  FEFaceValues<dim> face_values(
    discretization.mapping(),
    discretization.fe,
    QGauss<dim - 1>(discretization.n_gauss_points()),
    update_values | update_JxW_values | update_normal_vectors);
  dealii::Vector<double> cell_forces(discretization.fe.n_dofs_per_cell());
  std::vector<Index<dim>> indices(discretization.fe.n_dofs_per_cell());
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        cell_forces = 0;
        if (loads.body_force != Tensor<1, dim>())
          {
            fe_values.reinit(cell);
            add_density<dim>(
              fe_values,
              [&](const unsigned int) { return loads.body_force; },
              cell_forces);
          }
        for (const unsigned int face : cell->face_indices())
          if (cell->face(face)->at_boundary())
            {
              // A face of the surface keeps its number in refined cells.
              const auto load =
                loads.surface_loads.find({discretization.element(cell), face});
              if (load == loads.surface_loads.end())
                continue;
              face_values.reinit(cell, face);
              add_density<dim>(
                face_values,
                [&](const unsigned int q) {
                  return load->second.traction -
                         (pressure_follows ? 0. : load->second.pressure) *
                           face_values.normal_vector(q);
                },
                cell_forces);
            }
        cell->get_dof_indices(indices);
        forces.add(indices, cell_forces);
      }
}



/** Call `action` for each loaded node of each cell of this process. */
template <int dim, typename Action>
void
for_each_loaded_node(const Discretization<dim> &discretization,
                     const LoadParameters<dim> &loads,
                     const Body<dim> &body,
                     const Action &action)
{
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const unsigned int element = discretization.element(cell);
        const auto points          = discretization.points_in_element(cell);
        const auto nodes           = discretization.node_indices(cell);
        for (unsigned int node = 0; node < nodes.size(); ++node)
          {
            const auto of_body = node_at(points[node]);
            if (!of_body)
              continue;
            const unsigned int number = body.node_numbers[element][*of_body];
            if (loads.nodal_forces.count(number) > 0)
              action(number, nodes[node]);
          }
      }
}



/** Add the forces on nodes: every cell that has the node gives its share. */
template <int dim>
void
add_nodal_forces(const Discretization<dim> &discretization,
                 const LoadParameters<dim> &loads,
                 const Body<dim> &body,
                 LA::Vector &forces)
{
  using NodeIndices = typename Discretization<dim>::NodeIndices;
  std::map<unsigned int, unsigned int> n_cells;
  for (const auto &[number, force] : loads.nodal_forces)
    n_cells[number] = 0;
  for_each_loaded_node<dim>(
    discretization,
    loads,
    body,
    [&](const unsigned int number, const NodeIndices &) { ++n_cells[number]; });
  for (auto &[number, n] : n_cells)
    n = Utilities::MPI::sum(n, discretization.communicator);

  for_each_loaded_node<dim>(
    discretization,
    loads,
    body,
    [&](const unsigned int number, const NodeIndices &node) {
      for (unsigned int c = 0; c < dim; ++c)
        {
          const double share =
            loads.nodal_forces.at(number)[c] / n_cells.at(number);
          forces.add(1, &node[c], &share);
        }
    });
}
} // namespace


template <int dim>
LA::Vector
assemble_loads(const Discretization<dim> &discretization,
               const LoadParameters<dim> &loads,
               const Body<dim> &body,
               const bool pressure_follows)
{
  LA::Vector forces = discretization.zero_vector();
  if (loads.empty())
    return forces;
  add_distributed_loads(discretization, loads, pressure_follows, forces);
  if (!loads.nodal_forces.empty())
    add_nodal_forces(discretization, loads, body, forces);
  forces.compress(VectorOperation::add);
  return forces;
}



template LA::Vector
assemble_loads(const Discretization<2> &,
               const LoadParameters<2> &,
               const Body<2> &,
               const bool);
template LA::Vector
assemble_loads(const Discretization<3> &,
               const LoadParameters<3> &,
               const Body<3> &,
               const bool);
} // namespace Setsudan
