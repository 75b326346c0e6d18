#include <setsudan/elasticity/loose_pieces.h>
#include <setsudan/elasticity/resultant.h>

#include <set>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

template <int dim>
std::vector<LoosePiece>
find_loose_pieces(const CoarseMesh<dim> &mesh,
                  const std::vector<unsigned int> &pieces,
                  const Supports<dim> &supports)
{
  std::map<unsigned int, std::vector<unsigned int>> elements_of_piece;
  for (unsigned int element = 0; element < pieces.size(); ++element)
    elements_of_piece[pieces[element]].push_back(element);

  std::vector<LoosePiece> loose;
  for (const auto &[piece, elements] : elements_of_piece)
    {
      std::set<unsigned int> numbers;
      for (const unsigned int element : elements)
        numbers.insert(mesh.cells[element].vertices.begin(),
                       mesh.cells[element].vertices.end());
      const std::vector<unsigned int> vertices(numbers.begin(), numbers.end());
      std::vector<Point<dim>> candidates;
      for (const unsigned int vertex : vertices)
        candidates.push_back(mesh.vertices[vertex]);
      LoosePiece result{
        piece, find_minimal_hold(supports.held_points(elements), candidates)};
      for (auto &component : result.hold)
        component.first = vertices[component.first];
      if (!result.hold.empty())
        loose.push_back(result);
    }
  return loose;
}



template <int dim>
void
check_loads_on_loose_piece(const ElasticModel<dim> &model,
                           const std::vector<unsigned int> &pieces,
                           const LoosePiece &loose)
{
  const auto &discretization = model.discretization;
  const auto &sites          = discretization.sites();
  std::set<types::global_dof_index> own;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned() &&
        pieces[discretization.element(cell)] == loose.piece)
      for (const auto &node : discretization.node_indices(cell))
        for (const auto index : node)
          if (discretization.owned.is_element(index))
            own.insert(index);

  Resultant<dim> resultant(discretization);
  for (const auto index : own)
    {
      const auto &site = sites[discretization.owned.index_within_set(index)];
      Tensor<1, dim> force;
      force[site.component] = model.loads(index);
      resultant.add(site.position, force);
    }
  resultant.sum_over_processes();
  const Balance balance = resultant.relative();
  if (balance.force_residual > 1e-9 || balance.moment_residual > 1e-9)
    {
      std::ostringstream message;
      message << "Piece " << loose.piece
              << " has lost its support, and the loads on it are not in "
                 "equilibrium (relative residual of force "
              << balance.force_residual << ", of moment "
              << balance.moment_residual
              << "): nothing keeps it in place. Hold it in subsection Support, "
                 "remove the loads, or set Support/Loose pieces = drop.";
      throw std::runtime_error(message.str());
    }
}



namespace
{
/** Call `action` for each cell of a piece that this process knows. */
template <int dim, typename Action>
void
for_each_cell(const Discretization<dim> &discretization,
              const std::vector<unsigned int> &pieces,
              const LoosePiece &loose,
              const Action &action)
{
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (!cell->is_artificial() &&
        pieces[discretization.element(cell)] == loose.piece)
      action(cell);
}
} // namespace


template <int dim>
void
constrain_loose_piece(const Discretization<dim> &discretization,
                      const CoarseMesh<dim> &mesh,
                      const std::vector<unsigned int> &pieces,
                      const LoosePiece &loose,
                      AffineConstraints<double> &constraints)
{
  for_each_cell<dim>(discretization, pieces, loose, [&](const auto &cell) {
    const auto &vertices = mesh.cells[discretization.element(cell)].vertices;
    const auto points    = discretization.points_in_element(cell);
    const auto nodes     = discretization.node_indices(cell);
    for (const auto &[vertex, component] : loose.hold)
      for (unsigned int v = 0; v < vertices.size(); ++v)
        if (vertices[v] == vertex &&
            points[v] == GeometryInfo<dim>::unit_cell_vertex(v))
          constraints.add_line(nodes[v][component]);
  });
}



template <int dim>
void
constrain_dropped_piece(const Discretization<dim> &discretization,
                        const std::vector<unsigned int> &pieces,
                        const LoosePiece &loose,
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
                        const LoosePiece &loose,
                        ElasticModel<dim> &model)
{
  for_each_cell<dim>(
    model.discretization, pieces, loose, [&](const auto &cell) {
      for (const auto &node : model.discretization.node_indices(cell))
        for (const auto index : node)
          if (model.discretization.owned.is_element(index))
            {
              model.loads(index)      = 0;
              model.prescribed(index) = 0;
            }
    });
  model.loads.compress(VectorOperation::insert);
  model.prescribed.compress(VectorOperation::insert);
}



template std::vector<LoosePiece>
find_loose_pieces(const CoarseMesh<2> &,
                  const std::vector<unsigned int> &,
                  const Supports<2> &);
template std::vector<LoosePiece>
find_loose_pieces(const CoarseMesh<3> &,
                  const std::vector<unsigned int> &,
                  const Supports<3> &);
template void
check_loads_on_loose_piece(const ElasticModel<2> &,
                           const std::vector<unsigned int> &,
                           const LoosePiece &);
template void
check_loads_on_loose_piece(const ElasticModel<3> &,
                           const std::vector<unsigned int> &,
                           const LoosePiece &);
template void
constrain_loose_piece(const Discretization<2> &,
                      const CoarseMesh<2> &,
                      const std::vector<unsigned int> &,
                      const LoosePiece &,
                      AffineConstraints<double> &);
template void
constrain_dropped_piece(const Discretization<2> &,
                        const std::vector<unsigned int> &,
                        const LoosePiece &,
                        AffineConstraints<double> &);
template void
remove_loads_from_piece(const std::vector<unsigned int> &,
                        const LoosePiece &,
                        ElasticModel<2> &);
template void
constrain_loose_piece(const Discretization<3> &,
                      const CoarseMesh<3> &,
                      const std::vector<unsigned int> &,
                      const LoosePiece &,
                      AffineConstraints<double> &);
template void
constrain_dropped_piece(const Discretization<3> &,
                        const std::vector<unsigned int> &,
                        const LoosePiece &,
                        AffineConstraints<double> &);
template void
remove_loads_from_piece(const std::vector<unsigned int> &,
                        const LoosePiece &,
                        ElasticModel<3> &);
} // namespace Setsudan
