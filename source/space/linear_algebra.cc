// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/space/linear_algebra.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** All rows on the first process. */
IndexSet
rows_of_first_process(const types::global_dof_index n,
                      const MPI_Comm communicator)
{
  IndexSet rows(n);
  if (Utilities::MPI::this_mpi_process(communicator) == 0)
    rows.add_range(0, n);
  return rows;
}
} // namespace


void
distribute(const AffineConstraints<double> &constraints, LA::Vector &vector)
{
  if (Utilities::MPI::n_mpi_processes(vector.get_mpi_communicator()) > 1)
    {
      constraints.distribute(vector);
      return;
    }
  double *const entries = vector.trilinos_vector()[0];
  for (const auto &line : constraints.get_lines())
    {
      double value = line.inhomogeneity;
      for (const auto &[index, weight] : line.entries)
        value += weight * entries[index];
      entries[line.index] = value;
    }
}



LA::Vector
condense(const AffineConstraints<double> &constraints, const LA::Vector &forces)
{
  LA::Vector condensed       = forces;
  condensed                  = 0;
  const auto [begin, end]    = forces.local_range();
  const double *const values = forces.trilinos_vector()[0];
  for (auto index = begin; index < end; ++index)
    if (const double force = values[index - begin]; force != 0)
      constraints.distribute_local_to_global(index, force, condensed);
  condensed.compress(VectorOperation::add);
  return condensed;
}



LA::SparseMatrix
gather(const LA::SparseMatrix &matrix)
{
  const Epetra_CrsMatrix &rows = matrix.trilinos_matrix();
  const MPI_Comm communicator  = matrix.get_mpi_communicator();
  const Epetra_Map map         = rows_of_first_process(matrix.m(), communicator)
                           .make_trilinos_map(communicator, false);
  Epetra_CrsMatrix gathered(Copy, map, map, rows.GlobalMaxNumEntries());
  gathered.Import(rows, Epetra_Import(map, rows.RowMap()), Insert);
  gathered.FillComplete(map, map);
  LA::SparseMatrix result;
  result.reinit(gathered, true);
  return result;
}



LA::Vector
gather(const LA::Vector &vector)
{
  const MPI_Comm communicator = vector.get_mpi_communicator();
  LA::Vector gathered(rows_of_first_process(vector.size(), communicator),
                      communicator);
  gathered.reinit(vector, false, true);
  return gathered;
}



void
scatter(const LA::Vector &gathered, LA::Vector &vector)
{
  vector.reinit(gathered, false, true);
}
} // namespace Setsudan
