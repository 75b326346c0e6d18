// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/mechanics/pieces/floating_pieces.h>

#include <set>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Call `action` for each cell of a piece that this process knows. */
template <int dim, typename Action>
void
for_each_cell(const Discretization<dim> &discretization,
              const std::vector<unsigned int> &pieces,
              const FloatingPiece &loose,
              const Action &action)
{
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (!cell->is_artificial() &&
        pieces[discretization.element(cell)] == loose.piece)
      action(cell);
}
} // namespace


template <int dim>
std::vector<types::global_dof_index>
unknowns_of_hold(const Discretization<dim> &discretization,
                 const CoarseMesh<dim> &mesh,
                 const std::vector<unsigned int> &pieces,
                 const std::vector<FloatingPiece> &loose)
{
  std::vector<types::global_dof_index> own;
  for (const auto &piece : loose)
    for_each_cell<dim>(discretization, pieces, piece, [&](const auto &cell) {
      const auto &vertices = mesh.cells[discretization.element(cell)].vertices;
      const auto points    = discretization.points_in_element(cell);
      const auto nodes     = discretization.node_indices(cell);
      for (const auto &[vertex, component] : piece.hold)
        for (unsigned int v = 0; v < vertices.size(); ++v)
          if (vertices[v] == vertex &&
              points[v] == GeometryInfo<dim>::unit_cell_vertex(v))
            own.push_back(nodes[v][component]);
    });
  std::set<types::global_dof_index> all;
  for (const auto &part :
       Utilities::MPI::all_gather(discretization.communicator, own))
    all.insert(part.begin(), part.end());
  return {all.begin(), all.end()};
}



template <int dim>
void
constrain_dropped_piece(const Discretization<dim> &discretization,
                        const std::vector<unsigned int> &pieces,
                        const FloatingPiece &loose,
                        AffineConstraints<double> &constraints)
{
  for_each_cell<dim>(discretization, pieces, loose, [&](const auto &cell) {
    for (const auto &node : discretization.node_indices(cell))
      for (const auto index : node)
        if (!constraints.is_constrained(index))
          constraints.add_line(index);
  });
}



template <int dim>
void
remove_loads_from_piece(const std::vector<unsigned int> &pieces,
                        const FloatingPiece &loose,
                        ElasticModel<dim> &model)
{
  for_each_cell<dim>(
    model.discretization, pieces, loose, [&](const auto &cell) {
      for (const auto &node : model.discretization.node_indices(cell))
        for (const auto index : node)
          if (model.discretization.owned.is_element(index))
            {
              model.loads(index) = 0;
              model.lift(index)  = 0;
            }
    });
  model.loads.compress(VectorOperation::insert);
  model.lift.compress(VectorOperation::insert);
}



template std::vector<types::global_dof_index>
unknowns_of_hold(const Discretization<2> &,
                 const CoarseMesh<2> &,
                 const std::vector<unsigned int> &,
                 const std::vector<FloatingPiece> &);
template void
constrain_dropped_piece(const Discretization<2> &,
                        const std::vector<unsigned int> &,
                        const FloatingPiece &,
                        AffineConstraints<double> &);
template void
remove_loads_from_piece(const std::vector<unsigned int> &,
                        const FloatingPiece &,
                        ElasticModel<2> &);
template std::vector<types::global_dof_index>
unknowns_of_hold(const Discretization<3> &,
                 const CoarseMesh<3> &,
                 const std::vector<unsigned int> &,
                 const std::vector<FloatingPiece> &);
template void
constrain_dropped_piece(const Discretization<3> &,
                        const std::vector<unsigned int> &,
                        const FloatingPiece &,
                        AffineConstraints<double> &);
template void
remove_loads_from_piece(const std::vector<unsigned int> &,
                        const FloatingPiece &,
                        ElasticModel<3> &);
} // namespace Setsudan
