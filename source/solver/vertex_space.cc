#include <deal.II/base/mpi.h>
#include <deal.II/base/mpi.templates.h>
#include <deal.II/fe/fe_q.h>

#include <setsudan/elasticity/reference_gradients.h>
#include <setsudan/elasticity/rigid_modes.h>
#include <setsudan/solver/vertex_space.h>

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


/** Sum up terms of the same unknown. */
template <typename Row>
void
unite(Row &row)
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
} // namespace


template <int dim>
VertexSpace<dim>::VertexSpace(ElasticModel<dim> &model,
                              const Constraints &constraints,
                              const ConstraintLines &lines)
  : model(model)
  , batches(model.batches())
  , constraints(constraints)
  , lines(lines)
  , vertices_of_node(find_vertices_of_nodes<dim>(model.discretization.nodes()))
  , numbers(batches.partitioner())
{
  find_nodes();
  number_vertices();
  ask_for_rows();
  make_transfer();
}



template <int dim>
void
VertexSpace<dim>::find_nodes()
{
  const auto &discretization = model.discretization;
  const auto &known          = *batches.partitioner();
  const unsigned int n_nodes = batches.n_nodes();
  sites.assign(known.locally_owned_size() + known.n_ghost_indices(),
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
        sites[place(cell, node, c)] = {cell,
                                       static_cast<unsigned char>(node),
                                       static_cast<unsigned char>(c)};
}



template <int dim>
unsigned int
VertexSpace<dim>::place(const unsigned int cell,
                        const unsigned int node,
                        const unsigned int component) const
{
  return node_places[cell * batches.n_nodes() + node] + component;
}



template <int dim>
void
VertexSpace<dim>::number_vertices()
{
  constexpr unsigned int n_vertices = GeometryInfo<dim>::vertices_per_cell;
  const MPI_Comm communicator       = model.discretization.communicator;
  const unsigned int n_owned        = numbers.locally_owned_size();
  const auto is_numbered            = [&](const unsigned int at) {
    return sites[at].node < n_vertices;
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
typename VertexSpace<dim>::Row
VertexSpace<dim>::row_of(const unsigned int at) const
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
  if (numbers.local_element(at) != not_a_vertex)
    return {{static_cast<Index>(numbers.local_element(at)), 1.}};
  const Site &site = sites[at];
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
VertexSpace<dim>::ask_for_rows()
{
  const auto &known           = *batches.partitioner();
  const MPI_Comm communicator = model.discretization.communicator;
  if (Utilities::MPI::n_mpi_processes(communicator) == 1)
    return;
  // An unknown that is constrained itself is never asked for.
  std::map<unsigned int, std::vector<Index>> asked;
  unsigned int ghost = known.locally_owned_size();
  for (const auto &[process, n_ghosts] : known.ghost_targets())
    for (unsigned int i = 0; i < n_ghosts; ++i, ++ghost)
      if (sites[ghost].node == unknown_node &&
          numbers.local_element(ghost) == not_a_vertex &&
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
void
VertexSpace<dim>::make_transfer()
{
  const auto &known          = *batches.partitioner();
  const unsigned int n_owned = known.locally_owned_size();
  std::vector<Index> numbers_of_columns;
  starts.reserve(n_owned + 1);
  starts.push_back(0);
  for (unsigned int at = 0; at < n_owned; ++at)
    {
      if (!lines.is_constrained(at))
        {
          const Site &site     = sites[at];
          const auto &vertices = vertices_of_node[site.node];
          // Most nodes have nothing to do with a constraint.
          bool is_plain = true;
          for (const unsigned int v : vertices)
            is_plain = is_plain && !lines.is_constrained(
                                     place(site.cell, v, site.component));
          if (is_plain)
            for (const unsigned int v : vertices)
              {
                numbers_of_columns.push_back(
                  numbers.local_element(place(site.cell, v, site.component)));
                weights.push_back(1. / vertices.size());
              }
          else
            for (const auto &[number, weight] : row_of(at))
              {
                numbers_of_columns.push_back(number);
                weights.push_back(weight);
              }
        }
      starts.push_back(numbers_of_columns.size());
    }
  const Index n_numbers =
    Utilities::MPI::sum(n_owned_numbers, model.discretization.communicator);
  IndexSet owned(n_numbers), ghosts(n_numbers);
  owned.add_range(first_number, first_number + n_owned_numbers);
  std::vector<Index> others;
  for (const Index number : numbers_of_columns)
    if (!owned.is_element(number))
      others.push_back(number);
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  ghosts.add_indices(others.begin(), others.end());
  coarse_partitioner = std::make_shared<const Utilities::MPI::Partitioner>(
    owned, ghosts, model.discretization.communicator);
  for (const Index number : numbers_of_columns)
    columns.push_back(coarse_partitioner->global_to_local(number));
}



template <int dim>
const std::shared_ptr<const Utilities::MPI::Partitioner> &
VertexSpace<dim>::partitioner() const
{
  return coarse_partitioner;
}



template <int dim>
void
VertexSpace<dim>::prolongate_and_add(Vector &fine, Vector &coarse) const
{
  coarse.update_ghost_values();
  for (unsigned int at = 0; at + 1 < starts.size(); ++at)
    {
      double sum = 0;
      for (unsigned int e = starts[at]; e < starts[at + 1]; ++e)
        sum += weights[e] * coarse.local_element(columns[e]);
      fine.local_element(at) += sum;
    }
  coarse.zero_out_ghost_values();
}



template <int dim>
void
VertexSpace<dim>::restrict_forces(Vector &coarse, const Vector &fine) const
{
  coarse = 0;
  for (unsigned int at = 0; at + 1 < starts.size(); ++at)
    for (unsigned int e = starts[at]; e < starts[at + 1]; ++e)
      coarse.local_element(columns[e]) += weights[e] * fine.local_element(at);
  coarse.compress(VectorOperation::add);
}



template <int dim>
bool
VertexSpace<dim>::is_constrained(const unsigned int cell) const
{
  for (unsigned int node = 0; node < batches.n_nodes(); ++node)
    for (unsigned int c = 0; c < dim; ++c)
      if (lines.is_constrained(place(cell, node, c)))
        return true;
  return false;
}



template <int dim>
NodeBlocks<dim>
VertexSpace<dim>::stiffness() const
{
  constexpr unsigned int n_vertices = GeometryInfo<dim>::vertices_per_cell;
  const auto &kernel                = batches.kernel;
  const auto gradients              = reference_gradients<dim>(
    FE_Q<dim>(1), model.discretization.n_gauss_points());
  AlignedVector<double> of_batch(n_vertices * dim * n_vertices * dim *
                                 kernel.n_lanes);
  NodeBlocks<dim> blocks(first_number / dim,
                         n_owned_numbers / dim,
                         model.discretization.communicator);
  unsigned int first_cell = 0;
  for (unsigned int b = 0; b < batches.size(); ++b)
    {
      const CellBatch batch = batches[b];
      if (!batches.is_like_last(b))
        kernel.integrate(
          batch, gradients.data(), n_vertices, false, of_batch.data());
      for (unsigned int lane = 0; lane < batch.n_cells; ++lane)
        add_cell(first_cell + lane, lane, of_batch, blocks);
      first_cell += batch.n_cells;
    }
  blocks.finish();
  return blocks;
}



template <int dim>
void
VertexSpace<dim>::add_cell(const unsigned int cell,
                           const unsigned int lane,
                           const AlignedVector<double> &of_batch,
                           NodeBlocks<dim> &blocks) const
{
  constexpr unsigned int n_vertices = GeometryInfo<dim>::vertices_per_cell;
  constexpr unsigned int n          = n_vertices * dim;
  const unsigned int n_lanes        = batches.kernel.n_lanes;
  const auto entry = [&](const unsigned int i, const unsigned int j) {
    return of_batch[(i * n + j) * n_lanes + lane];
  };
  if (!is_constrained(cell))
    {
      std::array<Index, n_vertices> nodes;
      for (unsigned int v = 0; v < n_vertices; ++v)
        nodes[v] = numbers.local_element(place(cell, v, 0)) / dim;
      for (unsigned int v = 0; v < n_vertices; ++v)
        for (unsigned int w = 0; w < n_vertices; ++w)
          {
            double *const block = blocks.block(nodes[v], nodes[w]);
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int d = 0; d < dim; ++d)
                block[c * dim + d] += entry(v * dim + c, w * dim + d);
          }
      return;
    }

  std::vector<Row> rows;
  for (unsigned int node = 0; node < batches.n_nodes(); ++node)
    for (unsigned int c = 0; c < dim; ++c)
      rows.push_back(row_of(place(cell, node, c)));
  if (are_linear(rows))
    {
      rows.resize(n);
      add_product(rows, entry, blocks);
    }
  else
    {
      const auto &matrix = model.stiffness(batches.cells()[cell]);
      const auto &fe     = model.discretization.fe;
      std::vector<unsigned int> unknown(rows.size());
      for (unsigned int i = 0; i < rows.size(); ++i)
        {
          const auto [component, node]    = fe.system_to_component_index(i);
          unknown[node * dim + component] = i;
        }
      add_product(
        rows,
        [&](const unsigned int i, const unsigned int j) {
          return matrix(unknown[i], unknown[j]);
        },
        blocks);
    }
}



template <int dim>
bool
VertexSpace<dim>::are_linear(const std::vector<Row> &rows) const
{
  for (unsigned int node = 0; node < vertices_of_node.size(); ++node)
    for (unsigned int c = 0; c < dim; ++c)
      {
        const auto &vertices = vertices_of_node[node];
        Row difference       = rows[node * dim + c];
        for (const unsigned int vertex : vertices)
          for (const auto &[number, weight] : rows[vertex * dim + c])
            difference.emplace_back(number, -weight / vertices.size());
        unite(difference);
        for (const auto &term : difference)
          if (std::abs(term.second) > 1e-12)
            return false;
      }
  return true;
}



template <int dim>
template <typename Entry>
void
VertexSpace<dim>::add_product(const std::vector<Row> &rows,
                              const Entry &entry,
                              NodeBlocks<dim> &blocks) const
{
  for (unsigned int i = 0; i < rows.size(); ++i)
    for (unsigned int j = 0; j < rows.size(); ++j)
      for (const auto &[row, weight] : rows[i])
        for (const auto &[column, other] : rows[j])
          blocks.block(row / dim,
                       column / dim)[row % dim * dim + column % dim] +=
            weight * other * entry(i, j);
}



template <int dim>
std::vector<std::vector<double>>
VertexSpace<dim>::rigid_modes() const
{
  constexpr unsigned int n_vertices = GeometryInfo<dim>::vertices_per_cell;
  std::vector<std::vector<double>> modes(n_rigid_modes<dim>);
  const auto &positions = model.discretization.sites();
  for (unsigned int at = 0; at < positions.size(); ++at)
    if (sites[at].node < n_vertices)
      {
        const auto motions =
          Setsudan::rigid_modes(positions[at].position, Point<dim>(), 1.);
        for (unsigned int m = 0; m < modes.size(); ++m)
          modes[m].push_back(motions[m][positions[at].component]);
      }
  return modes;
}



template class VertexSpace<2>;
template class VertexSpace<3>;
} // namespace Setsudan
