// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>
#include <deal.II/base/mpi.templates.h>

#include <setsudan/solver/multigrid/block_matrix_assembler.h>

#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>

#include <algorithm>
#include <map>

namespace Setsudan
{
using namespace dealii;

template <int dim>
BlockMatrixAssembler<dim>::BlockMatrixAssembler(const Index first,
                                                const Index n_owned,
                                                const MPI_Comm communicator)
  : first(first)
  , communicator(communicator)
  , rows(n_owned)
{
}



template <int dim>
bool
BlockMatrixAssembler<dim>::owns(const Index node) const
{
  return node >= first && node - first < rows.size();
}



template <int dim>
typename BlockMatrixAssembler<dim>::RowOfNode &
BlockMatrixAssembler<dim>::row_of(const Index node)
{
  return owns(node) ? rows[node - first] : rows_of_others[node];
}



template <int dim>
double *
BlockMatrixAssembler<dim>::block(const Index row, const Index column)
{
  constexpr unsigned int size = dim * dim;
  // Where as many cells meet as in a box.
  constexpr unsigned int n_neighbors = dim == 2 ? 9 : 27;
  RowOfNode &of_node                 = row_of(row);
  if (of_node.columns.empty())
    {
      of_node.columns.reserve(n_neighbors);
      of_node.values.reserve(n_neighbors * size);
    }
  const auto begin     = of_node.columns.begin();
  const auto found     = std::find(begin, of_node.columns.end(), column);
  const std::size_t at = found - begin;
  if (found == of_node.columns.end())
    {
      of_node.columns.push_back(column);
      of_node.values.resize(of_node.values.size() + size, 0.);
    }
  return &of_node.values[at * size];
}



template <int dim>
void
BlockMatrixAssembler<dim>::finish()
{
  constexpr unsigned int size = dim * dim;
  std::vector<Index> firsts   = Utilities::MPI::all_gather(communicator, first);
  std::map<unsigned int, std::vector<Index>> nodes, columns;
  std::map<unsigned int, std::vector<double>> values;
  for (auto &[node, row] : rows_of_others)
    {
      const unsigned int owner =
        std::upper_bound(firsts.begin(), firsts.end(), node) - firsts.begin() -
        1;
      for (unsigned int e = 0; e < row.columns.size(); ++e)
        {
          nodes[owner].push_back(node);
          columns[owner].push_back(row.columns[e]);
        }
      values[owner].insert(
        values[owner].end(), row.values.begin(), row.values.end());
    }
  rows_of_others.clear();
  if (Utilities::MPI::n_mpi_processes(communicator) > 1)
    {
      const auto their_nodes =
        Utilities::MPI::some_to_some(communicator, nodes);
      const auto their_columns =
        Utilities::MPI::some_to_some(communicator, columns);
      const auto their_values =
        Utilities::MPI::some_to_some(communicator, values);
      for (const auto &[process, theirs] : their_nodes)
        for (unsigned int e = 0; e < theirs.size(); ++e)
          {
            double *const mine = block(theirs[e], their_columns.at(process)[e]);
            for (unsigned int i = 0; i < size; ++i)
              mine[i] += their_values.at(process)[e * size + i];
          }
    }
  fill_diagonal();
}



template <int dim>
void
BlockMatrixAssembler<dim>::fill_diagonal()
{
  double sum           = 0;
  unsigned int n_terms = 0;
  for (unsigned int node = 0; node < rows.size(); ++node)
    for (unsigned int c = 0; c < dim; ++c)
      {
        const double entry = block(first + node, first + node)[c * dim + c];
        sum += entry;
        n_terms += entry != 0;
      }
  sum               = Utilities::MPI::sum(sum, communicator);
  n_terms           = Utilities::MPI::sum(n_terms, communicator);
  const double mean = n_terms > 0 ? sum / n_terms : 1;
  for (unsigned int node = 0; node < rows.size(); ++node)
    for (unsigned int c = 0; c < dim; ++c)
      {
        double &entry = block(first + node, first + node)[c * dim + c];
        if (entry == 0)
          entry = mean;
      }
}



template <int dim>
std::vector<typename BlockMatrixAssembler<dim>::Index>
BlockMatrixAssembler<dim>::columns_of_others() const
{
  std::vector<Index> others;
  for (const auto &row : rows)
    for (const Index column : row.columns)
      if (!owns(column))
        others.push_back(column);
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  return others;
}



template <int dim>
std::unique_ptr<Epetra_CrsMatrix>
BlockMatrixAssembler<dim>::matrix() const
{
  const Epetra_MpiComm processes(communicator);
  const auto others = columns_of_others();
  std::vector<int> unknowns, sizes;
  const auto add_node = [&](const Index node) {
    for (unsigned int c = 0; c < dim; ++c)
      unknowns.push_back(node * dim + c);
  };
  for (Index node = 0; node < rows.size(); ++node)
    {
      add_node(first + node);
      sizes.insert(sizes.end(), dim, dim * rows[node].columns.size());
    }
  const Epetra_Map row_map(-1, static_cast<int>(unknowns.size()), 0, processes);
  for (const Index node : others)
    add_node(node);
  const Epetra_Map column_map(
    -1, unknowns.size(), unknowns.data(), 0, processes);
  const auto place_of = [&](const Index node) -> Index {
    if (owns(node))
      return node - first;
    return rows.size() + (std::lower_bound(others.begin(), others.end(), node) -
                          others.begin());
  };

  auto matrix = std::make_unique<Epetra_CrsMatrix>(
    Copy, row_map, column_map, sizes.data(), true);
  std::vector<int> columns;
  std::vector<double> values;
  for (unsigned int node = 0; node < rows.size(); ++node)
    for (unsigned int c = 0; c < dim; ++c)
      {
        const RowOfNode &row = rows[node];
        columns.clear();
        values.clear();
        for (unsigned int e = 0; e < row.columns.size(); ++e)
          for (unsigned int d = 0; d < dim; ++d)
            {
              columns.push_back(place_of(row.columns[e]) * dim + d);
              values.push_back(row.values[(e * dim + c) * dim + d]);
            }
        matrix->InsertMyValues(
          node * dim + c, columns.size(), values.data(), columns.data());
      }
  matrix->FillComplete(row_map, row_map);
  matrix->OptimizeStorage();
  return matrix;
}



template class BlockMatrixAssembler<2>;
template class BlockMatrixAssembler<3>;
} // namespace Setsudan
