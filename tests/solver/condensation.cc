// SPDX-License-Identifier: LGPL-2.1-or-later
// What is left of a matrix when all unknowns but some are eliminated is what
// these are to each other, in one part or in two that are factored side by
// side; the rest is recovered from them, all of it or some; and a dense factor
// that grows is that of the whole matrix.

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <setsudan/kernel/blas.h>
#include <setsudan/solver/condensed/connected_components.h>
#include <setsudan/solver/condensed/incremental_cholesky.h>
#include <setsudan/solver/condensed/static_condensation.h>

#include <cmath>

#include "../mechanics/solved_model.h"
#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

const Assignments bar = {"Body/Elements=3, 2, 2",
                         "Support/Fixed faces=left",
                         "Load/Body force=0, 0, -1"};


LA::SparseMatrix
assemble(SolvedModel<3> &solved)
{
  LA::SparseMatrix matrix;
  assemble_stiffness(solved.model.discretization,
                     solved.model.stiffness,
                     solved.model.supports,
                     matrix);
  return matrix;
}


LA::Vector
solve(const CholeskyFactor &factor, const LA::Vector &b)
{
  LA::Vector x                = b;
  std::vector<double> ordered = factor.in_order(b);
  factor.forward_eliminate(ordered);
  factor.back_substitute(ordered);
  factor.from_order(ordered, x);
  return x;
}


/** Unknowns of the bar, not in order of their places. */
std::vector<unsigned int>
some_unknowns(const SolvedModel<3> &solved)
{
  std::vector<unsigned int> unknowns;
  for (unsigned int i = 0; i < solved.displacement.size(); i += 7)
    if (!solved.model.supports.is_constrained(i))
      unknowns.push_back(i);
  return unknowns;
}


void
test_solve(SolvedModel<3> &solved)
{
  const LA::SparseMatrix matrix = assemble(solved);
  const LA::Vector b = condense(solved.model.supports, solved.model.loads);
  LA::Vector x       = solve(CholeskyFactor(matrix), b);
  x -= solved.displacement;
  check_below(
    "solve", x.linfty_norm() / solved.displacement.linfty_norm(), 1e-10);
}


/** S times that part of the inverse is the identity. */
void
test_complement(SolvedModel<3> &solved)
{
  const LA::SparseMatrix matrix = assemble(solved);
  const auto last               = some_unknowns(solved);
  const CholeskyFactor whole(matrix);
  const StaticCondensation condensation(matrix, last);
  const SchurComplement &complement = condensation.stiffness();
  double error                      = 0;
  for (const unsigned int j : {0u, 1u, unsigned(last.size() - 1)})
    {
      LA::Vector unit    = solved.displacement;
      unit               = 0;
      unit(last[j])      = 1;
      const LA::Vector x = solve(whole, unit);
      for (unsigned int i = 0; i < last.size(); ++i)
        {
          double sum = 0;
          for (unsigned int k = 0; k < last.size(); ++k)
            sum += complement(i, k) * x(last[k]);
          error = std::max(error, std::abs(sum - (i == j)));
        }
    }
  check_below("complement", error, 1e-11);
}


/** A matrix several times along the diagonal. */
LA::SparseMatrix
repeat(const LA::SparseMatrix &matrix, const unsigned int n_times)
{
  const unsigned int n = matrix.m();
  const IndexSet all   = complete_index_set(n_times * n);
  DynamicSparsityPattern pattern(n_times * n);
  for (unsigned int part = 0; part < n_times; ++part)
    for (const auto &entry : matrix)
      pattern.add(part * n + entry.row(), part * n + entry.column());
  LA::SparseMatrix result;
  result.reinit(all, all, pattern, MPI_COMM_WORLD);
  for (unsigned int part = 0; part < n_times; ++part)
    for (const auto &entry : matrix)
      result.set(
        part * n + entry.row(), part * n + entry.column(), entry.value());
  result.compress(VectorOperation::insert);
  return result;
}


/** The solution by way of some unknowns is that of the whole matrix. */
void
test_parts(SolvedModel<3> &solved, const unsigned int n_parts)
{
  const LA::SparseMatrix matrix = repeat(assemble(solved), n_parts);
  std::cout << "parts: " << connected_components(matrix).size() << std::endl;
  std::vector<unsigned int> cut;
  const unsigned int n = solved.displacement.size();
  for (unsigned int part = 0; part < n_parts; ++part)
    for (const unsigned int unknown : some_unknowns(solved))
      cut.push_back(part * n + unknown);
  LA::Vector b(complete_index_set(n_parts * n), MPI_COMM_WORLD);
  for (unsigned int i = 0; i < b.size(); ++i)
    b(i) = std::sin(7. * i);
  const LA::Vector expected = solve(CholeskyFactor(matrix), b);

  const StaticCondensation condensation(matrix, cut);
  const auto eliminated = condensation.forward_eliminate(b);
  IncrementalCholesky of_cut(cut.size());
  of_cut.append(cut.size(), condensation.stiffness());
  auto u = eliminated.on_cut;
  of_cut.solve(u);
  LA::Vector x = b;
  condensation.back_substitute(eliminated, u, x);
  x -= expected;
  check_below("all", x.linfty_norm() / expected.linfty_norm(), 1e-11);
}


void
test_growing(SolvedModel<3> &solved)
{
  const auto last = some_unknowns(solved);
  const StaticCondensation condensation(assemble(solved), last);
  const SchurComplement &s = condensation.stiffness();
  IncrementalCholesky growing(last.size());
  const auto append = [&](const unsigned int n) {
    growing.append(n - growing.size(), s);
  };
  const auto error = [&](const unsigned int n) {
    std::vector<double> x(n, 1.);
    growing.solve(x);
    double largest = 0;
    for (unsigned int i = 0; i < x.size(); ++i)
      {
        double sum = -1;
        for (unsigned int j = 0; j < x.size(); ++j)
          sum += s(i, j) * x[j];
        largest = std::max(largest, std::abs(sum));
      }
    return largest;
  };
  append(5);
  check_below("at first", error(growing.size()), 1e-11);
  append(5);
  append(17);
  check_below("grown", error(growing.size()), 1e-11);
  growing.shrink(9);
  check_below("shrunk", error(growing.size()), 1e-11);
  append(last.size());
  check_below("whole", error(growing.size()), 1e-11);
  check_below("its first part", error(11), 1e-11);
}


void
test_failures()
{
  SolvedModel<3> solved(bar);
  LA::SparseMatrix matrix;
  AffineConstraints<double> nothing(solved.model.discretization.relevant);
  nothing.close();
  assemble_stiffness(
    solved.model.discretization, solved.model.stiffness, nothing, matrix);
  try
    {
      // The rigid motions' energy is round-off; this makes it negative.
      for (unsigned int i = 0; i < 6; ++i)
        matrix.set(i, i, -matrix.diag_element(i));
      matrix.compress(VectorOperation::insert);
      CholeskyFactor factor(matrix);
      std::cout << "FAILED: a matrix was factored that is not definite\n";
    }
  catch (const SolverError &error)
    {
      std::cout << error.what() << std::endl;
    }
  IncrementalCholesky growing(2);
  try
    {
      growing.append(2, [](const unsigned int i, const unsigned int j) {
        return i == j ? 1. : 2.;
      });
      std::cout << "FAILED: a matrix was factored that is not definite\n";
    }
  catch (const SolverError &error)
    {
      std::cout << error.what() << std::endl;
    }
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    // The tests are started with one thread; here parts are worked on by two.
    set_n_threads(2);
    SolvedModel<3> solved(bar);
    test_solve(solved);
    test_complement(solved);
    test_parts(solved, 1);
    test_parts(solved, 2);
    test_growing(solved);
    test_failures();
  });
}
