#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/vector.h>

#include <setsudan/elasticity/loads.h>

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
                      LA::Vector &forces)
{
  FEValues<dim> fe_values(discretization.mapping,
                          discretization.fe,
                          QGauss<dim>(3),
                          update_values | update_JxW_values);
  FEFaceValues<dim> face_values(discretization.mapping,
                                discretization.fe,
                                QGauss<dim - 1>(3),
                                update_values | update_JxW_values |
                                  update_normal_vectors);
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
              const auto id       = cell->face(face)->boundary_id();
              const auto pressure = loads.pressures.find(id);
              const auto traction = loads.tractions.find(id);
              if (pressure == loads.pressures.end() &&
                  traction == loads.tractions.end())
                continue;
              face_values.reinit(cell, face);
              add_density<dim>(
                face_values,
                [&](const unsigned int q) {
                  Tensor<1, dim> density;
                  if (pressure != loads.pressures.end())
                    density -= pressure->second * face_values.normal_vector(q);
                  if (traction != loads.tractions.end())
                    density += traction->second;
                  return density;
                },
                cell_forces);
            }
        cell->get_dof_indices(indices);
        forces.add(indices, cell_forces);
      }
}



/** Add the forces on nodes: every element that has the node gives its share. */
template <int dim>
void
add_nodal_forces(const Discretization<dim> &discretization,
                 const LoadParameters<dim> &loads,
                 const Body<dim> &body,
                 LA::Vector &forces)
{
  std::map<unsigned int, unsigned int> n_elements;
  for (unsigned int element = 0; element < body.mesh.cells.size(); ++element)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      {
        const unsigned int number = body.numbering.node_number(element, node);
        if (loads.nodal_forces.count(number) > 0)
          ++n_elements[number];
      }

  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const unsigned int element = discretization.element(cell);
        const auto nodes           = discretization.node_indices(cell);
        for (unsigned int node = 0; node < nodes.size(); ++node)
          {
            const unsigned int number =
              body.numbering.node_number(element, node);
            const auto load = loads.nodal_forces.find(number);
            if (load != loads.nodal_forces.end())
              for (unsigned int c = 0; c < dim; ++c)
                {
                  const double share = load->second[c] / n_elements.at(number);
                  forces.add(1, &nodes[node][c], &share);
                }
          }
      }
}
} // namespace


template <int dim>
LA::Vector
assemble_loads(const Discretization<dim> &discretization,
               const LoadParameters<dim> &loads,
               const Body<dim> &body)
{
  LA::Vector forces = discretization.zero_vector();
  if (loads.empty())
    return forces;
  add_distributed_loads(discretization, loads, forces);
  if (!loads.nodal_forces.empty())
    add_nodal_forces(discretization, loads, body, forces);
  forces.compress(VectorOperation::add);
  return forces;
}



template LA::Vector
assemble_loads(const Discretization<2> &,
               const LoadParameters<2> &,
               const Body<2> &);
template LA::Vector
assemble_loads(const Discretization<3> &,
               const LoadParameters<3> &,
               const Body<3> &);
} // namespace Setsudan
