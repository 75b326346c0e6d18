// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/fe/fe_q.h>

#include <setsudan/mechanics/law_kernel.h>
#include <setsudan/solver/multigrid/q1_coarse_space.h>
#include <setsudan/space/near_null_space.h>
#include <setsudan/space/reference_gradients.h>

#include <cmath>
#include <optional>

namespace Setsudan
{
using namespace dealii;

template <int dim>
Q1CoarseSpace<dim>::Q1CoarseSpace(const ElasticModel<dim> &model,
                                  const Constraints &constraints,
                                  const LocalConstraints &lines)
  : model(model)
  , batches(model.batches())
  , rows(model.discretization, batches, constraints, lines)
{
  make_transfer();
}



template <int dim>
void
Q1CoarseSpace<dim>::make_transfer()
{
  const unsigned int n_owned = batches.partitioner()->locally_owned_size();
  std::vector<Index> numbers;
  starts.push_back(0);
  for (unsigned int at = 0; at < n_owned; ++at)
    {
      for (const auto &[number, weight] : rows.row_of(at))
        {
          numbers.push_back(number);
          weights.push_back(weight);
        }
      starts.push_back(numbers.size());
    }
  const IndexSet owned = rows.owned_numbers();
  IndexSet ghosts(owned.size());
  for (const Index number : numbers)
    if (!owned.is_element(number))
      ghosts.add_index(number);
  ghosts.compress();
  coarse_partitioner = std::make_shared<const Utilities::MPI::Partitioner>(
    owned, ghosts, model.discretization.communicator);
  for (const Index number : numbers)
    columns.push_back(coarse_partitioner->global_to_local(number));
}



template <int dim>
const std::shared_ptr<const Utilities::MPI::Partitioner> &
Q1CoarseSpace<dim>::partitioner() const
{
  return coarse_partitioner;
}



template <int dim>
void
Q1CoarseSpace<dim>::prolongate_and_add(Vector &fine,
                                       Vector &coarse,
                                       const LocalConstraints *now) const
{
  coarse.update_ghost_values();
  for (unsigned int at = 0; at + 1 < starts.size(); ++at)
    {
      if (now != nullptr && now->is_constrained(at))
        continue;
      double sum = 0;
      for (unsigned int e = starts[at]; e < starts[at + 1]; ++e)
        sum += weights[e] * coarse.local_element(columns[e]);
      fine.local_element(at) += sum;
    }
  coarse.zero_out_ghost_values();
}



template <int dim>
void
Q1CoarseSpace<dim>::restrict_forces(Vector &coarse, const Vector &fine) const
{
  coarse = 0;
  for (unsigned int at = 0; at + 1 < starts.size(); ++at)
    for (unsigned int e = starts[at]; e < starts[at + 1]; ++e)
      coarse.local_element(columns[e]) += weights[e] * fine.local_element(at);
  coarse.compress(VectorOperation::add);
}



template <int dim>
BlockMatrixAssembler<dim>
Q1CoarseSpace<dim>::stiffness(
  std::shared_ptr<const typename CellBatches<dim>::Tangent> tangent) const
{
  constexpr unsigned int n_vertices = GeometryInfo<dim>::vertices_per_cell;
  const auto &kernel                = batches.kernel;
  const auto gradients              = reference_gradients<dim>(
    FE_Q<dim>(1), model.discretization.n_gauss_points());
  AlignedVector<double> of_batch(n_vertices * dim * n_vertices * dim *
                                 kernel.n_lanes);
  const auto owned = coarse_partitioner->local_range();
  BlockMatrixAssembler<dim> blocks(owned.first / dim,
                                   (owned.second - owned.first) / dim,
                                   model.discretization.communicator);
  std::optional<TangentMatrices<dim>> of_tangent;
  if (tangent)
    of_tangent.emplace(model, tangent);
  const MatrixOfCell matrix_of =
    [&](const unsigned int cell) -> const FullMatrix<double> & {
    return of_tangent ? (*of_tangent)(cell)
                      : model.stiffness(batches.cells()[cell]);
  };
  unsigned int first_cell = 0;
  for (unsigned int b = 0; b < batches.size(); ++b)
    {
      const CellBatch batch = batches.with_tangent(b, tangent.get());
      if (tangent || !batches.same_as_previous(b))
        kernel.integrate(
          batch, gradients.data(), n_vertices, false, of_batch.data());
      for (unsigned int lane = 0; lane < batch.n_cells; ++lane)
        add_cell(first_cell + lane, lane, of_batch, matrix_of, blocks);
      first_cell += batch.n_cells;
    }
  blocks.finish();
  return blocks;
}



template <int dim>
void
Q1CoarseSpace<dim>::add_cell(const unsigned int cell,
                             const unsigned int lane,
                             const AlignedVector<double> &of_batch,
                             const MatrixOfCell &matrix_of,
                             BlockMatrixAssembler<dim> &blocks) const
{
  constexpr unsigned int n_vertices = GeometryInfo<dim>::vertices_per_cell;
  constexpr unsigned int n          = n_vertices * dim;
  const unsigned int n_lanes        = batches.kernel.n_lanes;
  const auto entry = [&](const unsigned int i, const unsigned int j) {
    return of_batch[(i * n + j) * n_lanes + lane];
  };
  if (!rows.is_constrained(cell))
    {
      std::array<Index, n_vertices> nodes;
      for (unsigned int v = 0; v < n_vertices; ++v)
        nodes[v] = rows.number(rows.place(cell, v, 0)) / dim;
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

  std::vector<Row> rows_of_cell;
  for (unsigned int node = 0; node < batches.n_nodes(); ++node)
    for (unsigned int c = 0; c < dim; ++c)
      rows_of_cell.push_back(rows.row_of(rows.place(cell, node, c)));
  if (are_linear(rows_of_cell))
    {
      rows_of_cell.resize(n);
      add_product(rows_of_cell, entry, blocks);
    }
  else
    {
      const auto &matrix = matrix_of(cell);
      const auto &fe     = model.discretization.fe;
      std::vector<unsigned int> unknown(rows_of_cell.size());
      for (unsigned int i = 0; i < rows_of_cell.size(); ++i)
        {
          const auto [component, node]    = fe.system_to_component_index(i);
          unknown[node * dim + component] = i;
        }
      add_product(
        rows_of_cell,
        [&](const unsigned int i, const unsigned int j) {
          return matrix(unknown[i], unknown[j]);
        },
        blocks);
    }
}



template <int dim>
bool
Q1CoarseSpace<dim>::are_linear(const std::vector<Row> &rows_of_cell) const
{
  for (unsigned int node = 0; node < rows.vertices_of_node.size(); ++node)
    for (unsigned int c = 0; c < dim; ++c)
      {
        const auto &vertices = rows.vertices_of_node[node];
        Row difference       = rows_of_cell[node * dim + c];
        for (const unsigned int vertex : vertices)
          for (const auto &[number, weight] : rows_of_cell[vertex * dim + c])
            difference.emplace_back(number, -weight / vertices.size());
        Q1Interpolation<dim>::unite(difference);
        for (const auto &term : difference)
          if (std::abs(term.second) > 1e-12)
            return false;
      }
  return true;
}



template <int dim>
template <typename Entry>
void
Q1CoarseSpace<dim>::add_product(const std::vector<Row> &rows_of_cell,
                                const Entry &entry,
                                BlockMatrixAssembler<dim> &blocks) const
{
  for (unsigned int i = 0; i < rows_of_cell.size(); ++i)
    for (unsigned int j = 0; j < rows_of_cell.size(); ++j)
      for (const auto &[row, weight] : rows_of_cell[i])
        for (const auto &[column, other] : rows_of_cell[j])
          blocks.block(row / dim,
                       column / dim)[row % dim * dim + column % dim] +=
            weight * other * entry(i, j);
}



template <int dim>
std::vector<std::vector<double>>
Q1CoarseSpace<dim>::rigid_modes() const
{
  std::vector<typename Discretization<dim>::DofLocation> vertices;
  const auto &dof_locations = model.discretization.dof_locations();
  for (unsigned int at = 0; at < dof_locations.size(); ++at)
    if (rows.is_at_vertex(at))
      vertices.push_back(dof_locations[at]);
  return rigid_modes_at<dim>(vertices);
}



template class Q1CoarseSpace<2>;
template class Q1CoarseSpace<3>;
} // namespace Setsudan
