#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>

#include <setsudan/elasticity/discretization.h>
#include <setsudan/element/fe_q_serendipity.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
Discretization<dim>::Discretization(const CoarseMesh<dim> &mesh,
                                    const MPI_Comm communicator)
  : communicator(communicator)
  , mapping(1)
  , fe(FE_Q_Serendipity<dim>(), dim)
  , triangulation(communicator)
  , dof_handler(triangulation)
{
  create_triangulation(mesh, triangulation);
  dof_handler.distribute_dofs(fe);
  owned = dof_handler.locally_owned_dofs();
  DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
}



template <int dim>
unsigned int
Discretization<dim>::element(const Cell &cell) const
{
  typename Triangulation<dim>::cell_iterator ancestor = cell;
  while (ancestor->level() > 0)
    ancestor = ancestor->parent();
  return ancestor->index();
}



template <int dim>
std::array<typename Discretization<dim>::NodeIndices, n_element_nodes<dim>>
Discretization<dim>::node_indices(const Cell &cell) const
{
  std::vector<Index> indices(fe.n_dofs_per_cell());
  cell->get_dof_indices(indices);
  std::array<NodeIndices, n_element_nodes<dim>> nodes;
  for (unsigned int node = 0; node < nodes.size(); ++node)
    for (unsigned int c = 0; c < dim; ++c)
      nodes[node][c] = indices[fe.component_to_system_index(c, node)];
  return nodes;
}



template <int dim>
LA::Vector
Discretization<dim>::zero_vector() const
{
  return LA::Vector(owned, communicator);
}



template <int dim>
LA::Vector
Discretization<dim>::with_ghosts(const LA::Vector &vector) const
{
  LA::Vector ghosted(owned, relevant, communicator);
  ghosted = vector;
  return ghosted;
}



template <int dim>
std::vector<typename Discretization<dim>::Site>
Discretization<dim>::sites() const
{
  std::vector<Site> sites(owned.n_elements());
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const auto nodes = node_indices(cell);
        for (unsigned int node = 0; node < nodes.size(); ++node)
          {
            const Point<dim> position = mapping.transform_unit_to_real_cell(
              cell, unit_point_of_node<dim>(node));
            for (unsigned int c = 0; c < dim; ++c)
              if (owned.is_element(nodes[node][c]))
                sites[owned.index_within_set(nodes[node][c])] = {position, c};
          }
      }
  return sites;
}



template <int dim>
void
constrain_supports(const Discretization<dim> &discretization,
                   const Supports<dim> &supports,
                   AffineConstraints<double> &constraints)
{
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (!cell->is_artificial())
      {
        const unsigned int element = discretization.element(cell);
        const auto nodes           = discretization.node_indices(cell);
        for (unsigned int node = 0; node < nodes.size(); ++node)
          if (supports.is_fixed(element, node))
            for (const auto index : nodes[node])
              constraints.add_line(index);
      }
}



template class Discretization<2>;
template class Discretization<3>;
template void
constrain_supports(const Discretization<2> &,
                   const Supports<2> &,
                   AffineConstraints<double> &);
template void
constrain_supports(const Discretization<3> &,
                   const Supports<3> &,
                   AffineConstraints<double> &);
} // namespace Setsudan
