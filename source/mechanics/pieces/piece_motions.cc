// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/mechanics/pieces/piece_motions.h>
#include <setsudan/parameters/exceptions.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

template <int dim>
PieceMotions<dim>::PieceMotions(const CoarseMesh<dim> &mesh,
                                const std::vector<unsigned int> &pieces,
                                const Supports<dim> &supports,
                                const std::vector<CellFace> &on_board)
{
  std::set<unsigned int> carried;
  for (const auto &face : on_board)
    carried.insert(pieces[face.first]);
  std::map<unsigned int, std::vector<unsigned int>> elements_of_piece;
  for (unsigned int element = 0; element < pieces.size(); ++element)
    elements_of_piece[pieces[element]].push_back(element);
  for (const auto &[number, elements] : elements_of_piece)
    {
      if (carried.count(number) > 0)
        continue;
      std::set<unsigned int> vertices;
      for (const unsigned int element : elements)
        vertices.insert(mesh.cells[element].vertices.begin(),
                        mesh.cells[element].vertices.end());
      Piece piece{
        {vertices.begin(), vertices.end()}, {}, supports.held_points(elements)};
      for (const unsigned int vertex : piece.vertices)
        piece.positions.push_back(mesh.vertices[vertex]);
      RigidBodyConstraints<dim> motions(
        {RigidBodyConstraints<dim>::frame_of(piece.positions)});
      for (const auto &point : piece.supports)
        motions.hold(0, point);
      if (!motions.holds_all())
        unheld.emplace(number, std::move(piece));
    }
}



template <int dim>
bool
PieceMotions<dim>::all_held() const
{
  return unheld.empty();
}



template <int dim>
std::vector<FloatingGroup<dim>>
PieceMotions<dim>::find_floating(const std::vector<PieceLink<dim>> &links) const
{
  std::map<unsigned int, std::vector<const PieceLink<dim> *>> links_of_piece;
  for (const auto &link : links)
    for (const unsigned int piece : link.pieces)
      if (unheld.count(piece) > 0)
        links_of_piece[piece].push_back(&link);

  std::vector<FloatingGroup<dim>> groups;
  std::set<unsigned int> seen;
  for (const auto &[first, piece] : unheld)
    {
      if (!seen.insert(first).second)
        continue;
      std::vector<unsigned int> numbers(1, first);
      std::set<const PieceLink<dim> *> of_group;
      for (unsigned int i = 0; i < numbers.size(); ++i)
        for (const auto *link : links_of_piece[numbers[i]])
          {
            of_group.insert(link);
            for (const unsigned int other : link->pieces)
              if (unheld.count(other) > 0 && seen.insert(other).second)
                numbers.push_back(other);
          }
      // In the order of the list, which is the same on every process.
      auto group = make_group(numbers, {of_group.begin(), of_group.end()});
      if (!group.loose.empty())
        groups.push_back(std::move(group));
    }
  return groups;
}



template <int dim>
FloatingGroup<dim>
PieceMotions<dim>::make_group(
  const std::vector<unsigned int> &numbers,
  const std::vector<const PieceLink<dim> *> &links) const
{
  std::map<unsigned int, unsigned int> body_of_piece;
  std::vector<typename RigidBodyConstraints<dim>::Frame> frames;
  std::vector<std::vector<Point<dim>>> candidates;
  for (const unsigned int number : numbers)
    {
      body_of_piece[number] = frames.size();
      candidates.push_back(unheld.at(number).positions);
      frames.push_back(RigidBodyConstraints<dim>::frame_of(candidates.back()));
    }
  RigidBodyConstraints<dim> motions(frames);
  for (const unsigned int number : numbers)
    for (const auto &point : unheld.at(number).supports)
      motions.hold(body_of_piece[number], point);
  for (const auto *link : links)
    {
      if (motions.holds_all())
        break;
      // A piece that is held by itself does not move.
      auto form   = motions.zero();
      double sign = 1;
      for (const unsigned int piece : link->pieces)
        {
          const auto body = body_of_piece.find(piece);
          if (body != body_of_piece.end())
            motions.add_displacement(
              body->second, link->position, sign * link->direction, form);
          sign = -1;
        }
      motions.hold(form);
    }

  FloatingGroup<dim> group{numbers, motions, {}};
  if (motions.holds_all())
    return group;
  const auto hold = motions.hold_all(candidates);
  for (unsigned int body = 0; body < numbers.size(); ++body)
    if (!group.held.holds(body))
      {
        group.loose.push_back({numbers[body], hold[body]});
        for (auto &component : group.loose.back().hold)
          component.first = unheld.at(numbers[body]).vertices[component.first];
      }
  return group;
}



template <int dim>
void
check_loads_on_loose_group(const ElasticModel<dim> &model,
                           const std::vector<unsigned int> &pieces,
                           const FloatingGroup<dim> &group)
{
  const auto &discretization = model.discretization;
  const auto &dof_locations  = discretization.dof_locations();
  std::map<types::global_dof_index, unsigned int> body_of_unknown;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const auto body = std::find(group.pieces.begin(),
                                    group.pieces.end(),
                                    pieces[discretization.element(cell)]);
        if (body == group.pieces.end())
          continue;
        for (const auto &node : discretization.node_indices(cell))
          for (const auto index : node)
            if (discretization.owned.is_element(index))
              body_of_unknown[index] = body - group.pieces.begin();
      }

  auto work        = group.held.zero();
  double magnitude = 0;
  for (const auto &[index, body] : body_of_unknown)
    {
      const auto &site =
        dof_locations[discretization.owned.index_within_set(index)];
      Tensor<1, dim> force;
      force[site.component] = model.loads(index);
      group.held.add_displacement(body, site.position, force, work);
      magnitude += force.norm();
    }
  Utilities::MPI::sum(work, discretization.communicator, work);
  magnitude = Utilities::MPI::sum(magnitude, discretization.communicator);
  const double free = group.held.unconstrained_part(work).l2_norm();
  if (free > 1e-9 * magnitude)
    {
      std::ostringstream message;
      message << "Piece " << group.loose.front().piece
              << " has lost its support, and the loads on it are not in "
                 "equilibrium (relative to their sum "
              << free / magnitude
              << " works in motions that nothing stops): nothing keeps it in "
                 "place. Hold it in subsection Support, remove the loads, or "
                 "set Support/Loose pieces = drop.";
      throw FloatingPieceError(message.str());
    }
}



template class PieceMotions<2>;
template class PieceMotions<3>;
template void
check_loads_on_loose_group(const ElasticModel<2> &,
                           const std::vector<unsigned int> &,
                           const FloatingGroup<2> &);
template void
check_loads_on_loose_group(const ElasticModel<3> &,
                           const std::vector<unsigned int> &,
                           const FloatingGroup<3> &);
} // namespace Setsudan
