// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/linear/mumps_solver.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_FEVector.h>
#include <Epetra_Import.h>
#include <dmumps_c.h>

#include <algorithm>
#include <string>

namespace Setsudan
{
using namespace dealii;

namespace
{
// Jobs, the host's communicator and errors of MUMPS (users' guide, 5.5).
constexpr int job_begin = -1, job_end = -2, job_analyze = 1, job_factorize = 2,
              job_solve          = 3;
constexpr int integers_too_small = -8, reals_too_small = -9,
              root_not_definite = -40;
// More than this beyond MUMPS's estimate would hide another error.
constexpr int most_spare_percent = 2000;
} // namespace


/** MUMPS with one matrix. */
class MumpsSolver::Instance
{
public:
  Instance(const LA::SparseMatrix &matrix, const bool is_definite);

  Instance(const Instance &) = delete;

  ~Instance();

  /** Factorize, with so much more workspace than MUMPS estimates; the answer is
   * whether that sufficed. */
  bool
  factorize(const int spare_percent);

  void
  solve(LA::Vector &x, const LA::Vector &b);

  /** Of the pivots. */
  int
  n_negative() const
  {
    return data.infog[11];
  }

private:
  /** The entry of MUMPS's list of controls with its number in the guide. */
  int &
  control(const int number)
  {
    return data.icntl[number - 1];
  }

  void
  run(const int job)
  {
    data.job = job;
    dmumps_c(&data);
  }

  void
  check(const std::string &what) const;

  /** The lower half of the matrix, as this process has it. */
  std::vector<int> rows, columns;
  std::vector<double> entries;
  /** All unknowns, on the first process. */
  const Epetra_Map host;
  const Epetra_Import to_host;
  DMUMPS_STRUC_C data{};
};



MumpsSolver::Instance::Instance(const LA::SparseMatrix &matrix,
                                const bool is_definite)
  : host(static_cast<int>(matrix.m()),
         Utilities::MPI::this_mpi_process(matrix.get_mpi_communicator()) == 0
           ? static_cast<int>(matrix.m())
           : 0,
         0,
         matrix.trilinos_matrix().Comm())
  , to_host(host, matrix.trilinos_matrix().RowMap())
{
  const auto [begin, end] = matrix.local_range();
  for (auto row = begin; row < end; ++row)
    {
      // To make an iterator is to copy a row.
      const auto last = matrix.end(row);
      for (auto entry = matrix.begin(row); entry != last; ++entry)
        if (entry->column() <= row)
          {
            // MUMPS counts from 1.
            rows.push_back(row + 1);
            columns.push_back(entry->column() + 1);
            entries.push_back(entry->value());
          }
    }
  data.comm_fortran = MPI_Comm_c2f(matrix.get_mpi_communicator());
  data.par          = 1;
  data.sym          = is_definite ? 1 : 2;
  run(job_begin);
  for (const int stream : {1, 2, 3})
    control(stream) = -1;
  control(4)                   = 0;
  constexpr int is_distributed = 3;
  control(18)                  = is_distributed;
  // Else it does not count the pivots of the last block.
  control(13)  = 1;
  data.n       = matrix.m();
  data.nnz_loc = entries.size();
  data.irn_loc = rows.data();
  data.jcn_loc = columns.data();
  data.a_loc   = entries.data();
  run(job_analyze);
  check("symbolic factorization");
}



MumpsSolver::Instance::~Instance()
{
  run(job_end);
}



void
MumpsSolver::Instance::check(const std::string &what) const
{
  const int error = data.infog[0];
  if (error == root_not_definite)
    throw NotDefiniteError("The direct solver's factorization found a matrix "
                           "that is not positive definite. Check that supports "
                           "hold the body.");
  if (error < 0)
    throw SolverError("The direct solver's " + what + " failed (MUMPS error " +
                      std::to_string(error) +
                      "): the matrix is singular to working precision, or "
                      "memory ran out. Check that supports hold the body, or "
                      "set Solver/Method = iterative.");
}



bool
MumpsSolver::Instance::factorize(const int spare_percent)
{
  control(14) = spare_percent;
  run(job_factorize);
  const int error = data.infog[0];
  if ((error == integers_too_small || error == reals_too_small) &&
      spare_percent < most_spare_percent)
    return false;
  check("numeric factorization");
  return true;
}



void
MumpsSolver::Instance::solve(LA::Vector &x, const LA::Vector &b)
{
  // It replaces the right-hand side, on the first process, by the solution.
  Epetra_Vector on_host(host);
  on_host.Import(b.trilinos_vector(), to_host, Insert);
  data.rhs = on_host.Values();
  run(job_solve);
  check("solve");
  x.trilinos_vector().Export(on_host, to_host, Insert);
}



MumpsSolver::MumpsSolver(const int spare_percent, const bool is_definite)
  : spare_percent(spare_percent)
  , is_definite(is_definite)
{
}



MumpsSolver::~MumpsSolver() = default;


void
MumpsSolver::initialize(const LA::SparseMatrix &matrix,
                        const std::vector<std::vector<double>> &)
{
  mumps.reset();
  mumps = std::make_unique<Instance>(matrix, is_definite);
  for (int percent = spare_percent; !mumps->factorize(percent);)
    percent = 2 * std::max(percent, 50);
  if (is_definite && mumps->n_negative() > 0)
    throw NotDefiniteError(
      "The direct solver's factorization found a matrix that is not positive "
      "definite. Check that supports hold the body.");
}



void
MumpsSolver::solve(LA::Vector &x, const LA::Vector &b)
{
  mumps->solve(x, b);
}



unsigned int
MumpsSolver::n_negative() const
{
  return mumps->n_negative();
}
} // namespace Setsudan
