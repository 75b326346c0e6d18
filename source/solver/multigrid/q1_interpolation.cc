// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>
#include <deal.II/base/mpi.templates.h>

#include <setsudan/solver/multigrid/q1_interpolation.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Setsudan
{
using namespace dealii;

namespace
{
constexpr double not_a_vertex = -1;
// No node of any cell known here.
constexpr unsigned char unknown_node = 255;


/** The vertices around each node: those whose coordinates it shares where it is
 * not in the middle. */
template <int dim>
std::vector<std::vector<unsigned int>>
find_vertices_of_nodes(const std::vector<Point<dim>> &nodes)
{
  std::vector<std::vector<unsigned int>> vertices(nodes.size());
  for (unsigned int node = 0; node < nodes.size(); ++node)
    for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
      {
        const auto vertex = GeometryInfo<dim>::unit_cell_vertex(v);
        bool is_around    = true;
        for (unsigned int d = 0; d < dim; ++d)
          is_around = is_around && std::abs(nodes[node][d] - vertex[d]) < 0.75;
        if (is_around)
          vertices[node].push_back(v);
      }
  return vertices;
}
} // namespace


template <int dim>
Q1Interpolation<dim>::Q1Interpolation(const Discretization<dim> &discretization,
                                      const CellBatches<dim> &batches,
                                      const Constraints &constraints,
                                      const LocalConstraints &lines)
  : vertices_of_node(find_vertices_of_nodes<dim>(discretization.nodes()))
  , discretization(discretization)
  , batches(batches)
  , constraints(constraints)
  , lines(lines)
  , numbers(batches.partitioner())
{
  find_nodes();
  number_vertices();
  ask_for_rows();
}



template <int dim>
void
Q1Interpolation<dim>::unite(Row &row)
{
  std::sort(row.begin(), row.end());
  unsigned int n = 0;
  for (const auto &term : row)
    if (n > 0 && row[n - 1].first == term.first)
      row[n - 1].second += term.second;
    else
      row[n++] = term;
  row.resize(n);
}



template <int dim>
void
Q1Interpolation<dim>::find_nodes()
{
  const auto &known          = *batches.partitioner();
  const unsigned int n_nodes = batches.n_nodes();
  dof_locations.assign(known.locally_owned_size() + known.n_ghost_indices(),
                       {0, unknown_node, 0});
  node_places.reserve(batches.cells().size() * n_nodes);
  for (unsigned int b = 0; b < batches.size(); ++b)
    {
      const CellBatch batch = batches[b];
      for (unsigned int lane = 0; lane < batch.n_cells; ++lane)
        for (unsigned int node = 0; node < n_nodes; ++node)
          node_places.push_back(
            batch.nodes[node * batches.kernel.n_lanes + lane]);
    }
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_ghost())
      for (const auto &indices : discretization.node_indices(cell))
        node_places.push_back(known.global_to_local(indices[0]));

  const unsigned int n_cells = node_places.size() / n_nodes;
  for (unsigned int cell = 0; cell < n_cells; ++cell)
    for (unsigned int node = 0; node < n_nodes; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        dof_locations[place(cell, node, c)] = {cell,
                                               static_cast<unsigned char>(node),
                                               static_cast<unsigned char>(c)};
}



template <int dim>
unsigned int
Q1Interpolation<dim>::place(const unsigned int cell,
                            const unsigned int node,
                            const unsigned int component) const
{
  return node_places[cell * batches.n_nodes() + node] + component;
}



template <int dim>
void
Q1Interpolation<dim>::number_vertices()
{
  constexpr unsigned int n_vertices = GeometryInfo<dim>::vertices_per_cell;
  const MPI_Comm communicator       = discretization.communicator;
  const unsigned int n_owned        = numbers.locally_owned_size();
  const auto is_numbered            = [&](const unsigned int at) {
    return dof_locations[at].node < n_vertices;
  };
  n_owned_numbers = 0;
  for (unsigned int at = 0; at < n_owned; ++at)
    n_owned_numbers += is_numbered(at);
  Index before = 0;
  MPI_Exscan(&n_owned_numbers,
             &before,
             1,
             DEAL_II_DOF_INDEX_MPI_TYPE,
             MPI_SUM,
             communicator);
  first_number =
    Utilities::MPI::this_mpi_process(communicator) == 0 ? 0 : before;
  Index next = first_number;
  // Numbers below 2^53 are exact as floating point ones.
  for (unsigned int at = 0; at < n_owned; ++at)
    numbers.local_element(at) = is_numbered(at) ? next++ : not_a_vertex;
  numbers.update_ghost_values();
}



template <int dim>
typename Q1Interpolation<dim>::Row
Q1Interpolation<dim>::row_of(const unsigned int at) const
{
  const auto index = batches.partitioner()->local_to_global(at);
  Row row;
  const auto add = [&](const unsigned int other, const double factor) {
    for (const auto &[number, weight] : row_of(other))
      row.emplace_back(number, factor * weight);
  };
  if (constraints.is_constrained(index))
    {
      for (const auto &[master, weight] :
           *constraints.get_constraint_entries(index))
        add(batches.partitioner()->global_to_local(master), weight);
      unite(row);
      return row;
    }
  if (is_at_vertex(at))
    return {{number(at), 1.}};
  const DofLocation &site = dof_locations[at];
  if (site.node == unknown_node)
    return rows_of_others.at(at);
  const auto &vertices = vertices_of_node[site.node];
  for (const unsigned int vertex : vertices)
    add(place(site.cell, vertex, site.component), 1. / vertices.size());
  unite(row);
  return row;
}



template <int dim>
void
Q1Interpolation<dim>::ask_for_rows()
{
  const auto &known           = *batches.partitioner();
  const MPI_Comm communicator = discretization.communicator;
  if (Utilities::MPI::n_mpi_processes(communicator) == 1)
    return;
  // An unknown that is constrained itself is never asked for.
  std::map<unsigned int, std::vector<Index>> asked;
  unsigned int ghost = known.locally_owned_size();
  for (const auto &[process, n_ghosts] : known.ghost_targets())
    for (unsigned int i = 0; i < n_ghosts; ++i, ++ghost)
      if (dof_locations[ghost].node == unknown_node && !is_at_vertex(ghost) &&
          !constraints.is_constrained(known.local_to_global(ghost)))
        asked[process].push_back(known.local_to_global(ghost));
  std::map<unsigned int, std::vector<Row>> answers;
  for (const auto &[process, indices] :
       Utilities::MPI::some_to_some(communicator, asked))
    for (const Index index : indices)
      answers[process].push_back(row_of(known.global_to_local(index)));
  for (const auto &[process, rows] :
       Utilities::MPI::some_to_some(communicator, answers))
    for (unsigned int i = 0; i < rows.size(); ++i)
      rows_of_others[known.global_to_local(asked.at(process)[i])] = rows[i];
}



template <int dim>
bool
Q1Interpolation<dim>::is_constrained(const unsigned int cell) const
{
  for (unsigned int node = 0; node < batches.n_nodes(); ++node)
    for (unsigned int c = 0; c < dim; ++c)
      if (lines.is_constrained(place(cell, node, c)))
        return true;
  return false;
}



template <int dim>
bool
Q1Interpolation<dim>::is_at_vertex(const unsigned int at) const
{
  return numbers.local_element(at) != not_a_vertex;
}



template <int dim>
types::global_dof_index
Q1Interpolation<dim>::number(const unsigned int at) const
{
  return static_cast<Index>(numbers.local_element(at));
}



template <int dim>
IndexSet
Q1Interpolation<dim>::owned_numbers() const
{
  IndexSet owned(
    Utilities::MPI::sum(n_owned_numbers, discretization.communicator));
  owned.add_range(first_number, first_number + n_owned_numbers);
  return owned;
}



template class Q1Interpolation<2>;
template class Q1Interpolation<3>;
} // namespace Setsudan
