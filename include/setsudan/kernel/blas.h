// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/kernel/instruction_set.h>

#include <string>

namespace Setsudan
{
/**
 * The kernels that OpenBLAS works with, by its own name for the processors that
 * they were written for ("Haswell"); empty where the BLAS is another one.
 */
std::string
blas_core();

/**
 * A better choice than OpenBLAS's own, which takes its oldest kernels on
 * processors that are newer than it is: several times slower.
 *
 * @param core      what it has chosen.
 * @param processor what the processor can do.
 * @return the name for OPENBLAS_CORETYPE; empty where the choice is good.
 */
std::string
better_blas_core(const std::string &core, const InstructionSet processor);

/**
 * Start the program anew where another choice of kernels, or threads that do
 * not wait busily, must be asked for before it begins. What is in the
 * environment already is the user's choice and stays.
 *
 * @param argv as main() has it.
 */
void
start_with_fitting_blas(char **argv);

/** Leave each of the processes on this machine its share of the processor's
 * cores, unless the environment says how many threads there shall be. */
void
share_cores(const unsigned int n_processes_here);

/** The threads that the BLAS may use, which the rest may, too. */
unsigned int
n_threads();

/** Let it use so many from now on. */
void
set_n_threads(const unsigned int n);

/** As long as it lives the BLAS uses one thread, so that others can call it. */
class SingleThreadedBlas
{
public:
  SingleThreadedBlas();
  ~SingleThreadedBlas();

  SingleThreadedBlas(const SingleThreadedBlas &) = delete;

private:
  const unsigned int n_before;
};

/** Make L^-1 x of x, or L^-T x, for one lower triangle.
 *
 * @param l      by columns of length `stride`. */
void
solve_triangle(const double *l,
               const int n,
               const int stride,
               const bool transposed,
               double *x);

/** The BLAS, its kernels and threads, and our own kernels, in one line. */
std::string
describe_blas();
} // namespace Setsudan
