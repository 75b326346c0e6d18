// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_fe_field.h>
#include <deal.II/fe/mapping_q.h>

#include <setsudan/mesh/geometry.h>
#include <setsudan/space/discretization.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
Discretization<dim>::Discretization(const CoarseMesh<dim> &mesh,
                                    const Refinement &refinement,
                                    const MPI_Comm communicator,
                                    const ElementType type)
  : communicator(communicator)
  , type(type)
  , fe(*make_element<dim>(type), dim)
  , triangulation(communicator)
  , dof_handler(triangulation)
  , mesh(mesh)
{
  create_triangulation(mesh, triangulation);
  refine<dim>(triangulation, refinement);
  dof_handler.distribute_dofs(fe);
  owned = dof_handler.locally_owned_dofs();
  DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
  zero.reinit(owned, communicator);
  zero_with_ghosts.reinit(owned, relevant, communicator);
  make_mapping();
  find_sites();
}



template <int dim>
void
Discretization<dim>::make_mapping()
{
  if (!mesh.is_curved())
    {
      shape = std::make_unique<MappingQ<dim>>(1);
      return;
    }
  LA::Vector own = curved_positions();
  // Where linear elements are refined, the fine side's corners lie on the
  // coarse side's straight lines, and not on the curve.
  if (type == ElementType::linear)
    {
      AffineConstraints<double> hanging(relevant);
      DoFTools::make_hanging_node_constraints(dof_handler, hanging);
      hanging.close();
      hanging.distribute(own);
    }
  positions = with_ghosts(own);
  shape = std::make_unique<MappingFEField<dim, dim, LA::Vector>>(dof_handler,
                                                                 positions);
}



template <int dim>
LA::Vector
Discretization<dim>::curved_positions() const
{
  LA::Vector own = zero_vector();
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const auto nodes     = node_indices(cell);
        const auto of_corner = mesh.node_positions(element(cell));
        const auto points    = points_in_element(cell);
        for (unsigned int node = 0; node < nodes.size(); ++node)
          if (owned.is_element(nodes[node][0]))
            {
              const Point<dim> position =
                cell->level() == 0 && node < of_corner.size()
                  ? of_corner[node]
                  : point_of_element(of_corner, points[node]);
              for (unsigned int c = 0; c < dim; ++c)
                own(nodes[node][c]) = position[c];
            }
      }
  own.compress(VectorOperation::insert);
  return own;
}



template <int dim>
bool
Discretization<dim>::is_curved() const
{
  return mesh.is_curved();
}



template <int dim>
const Mapping<dim> &
Discretization<dim>::mapping() const
{
  return *shape;
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
unsigned int
Discretization<dim>::n_gauss_points() const
{
  return type == ElementType::linear ? 2 : 3;
}



template <int dim>
const std::vector<Point<dim>> &
Discretization<dim>::nodes() const
{
  return fe.base_element(0).get_unit_support_points();
}



template <int dim>
std::vector<Point<dim>>
Discretization<dim>::points_in_element(const Cell &cell) const
{
  const CellPath path = path_of_cell<dim>(cell);
  std::vector<Point<dim>> points;
  for (const auto &node : nodes())
    points.push_back(point_in_element<dim>(path, node));
  return points;
}



template <int dim>
std::vector<Point<dim>>
Discretization<dim>::node_positions(const Cell &cell) const
{
  std::vector<Point<dim>> result(nodes().size());
  if (mesh.is_curved())
    {
      const auto nodes = node_indices(cell);
      for (unsigned int node = 0; node < result.size(); ++node)
        for (unsigned int c = 0; c < dim; ++c)
          result[node][c] = positions(nodes[node][c]);
    }
  else
    for (unsigned int node = 0; node < result.size(); ++node)
      {
        if (node >= n_element_nodes<dim>)
          {
            result[node] =
              shape->transform_unit_to_real_cell(cell, nodes()[node]);
            continue;
          }
        const auto ends = vertices_of_node<dim>(node);
        const auto &a   = cell->vertex(ends[0]);
        result[node]    = a + 0.5 * (cell->vertex(ends[1]) - a);
      }
  return result;
}



template <int dim>
std::vector<typename Discretization<dim>::NodeIndices>
Discretization<dim>::node_indices(const Cell &cell) const
{
  std::vector<Index> indices(fe.n_dofs_per_cell());
  cell->get_dof_indices(indices);
  std::vector<NodeIndices> nodes(fe.base_element(0).n_dofs_per_cell());
  for (unsigned int node = 0; node < nodes.size(); ++node)
    for (unsigned int c = 0; c < dim; ++c)
      nodes[node][c] = indices[fe.component_to_system_index(c, node)];
  return nodes;
}



template <int dim>
LA::Vector
Discretization<dim>::zero_vector() const
{
  return zero;
}



template <int dim>
LA::Vector
Discretization<dim>::with_ghosts(const LA::Vector &vector) const
{
  LA::Vector ghosted = zero_with_ghosts;
  ghosted            = vector;
  return ghosted;
}



template <int dim>
void
Discretization<dim>::find_sites()
{
  all_sites.resize(owned.n_elements());
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const auto nodes = node_indices(cell);
        const auto where = node_positions(cell);
        for (unsigned int node = 0; node < nodes.size(); ++node)
          for (unsigned int c = 0; c < dim; ++c)
            if (owned.is_element(nodes[node][c]))
              all_sites[owned.index_within_set(nodes[node][c])] = {where[node],
                                                                   c};
      }
}



template <int dim>
const std::vector<typename Discretization<dim>::DofLocation> &
Discretization<dim>::dof_locations() const
{
  return all_sites;
}



template class Discretization<2>;
template class Discretization<3>;
} // namespace Setsudan
