// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/kernel/blas.h>
#include <setsudan/kernel/stiffness_kernel.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <thread>

#include <dlfcn.h>
#include <unistd.h>

/** BLAS's solve for one right-hand side, which Teuchos does not wrap. */
extern "C" void
dtrsv_(const char *uplo,
       const char *transposed,
       const char *unit_diagonal,
       const int *n,
       const double *a,
       const int *lda,
       double *x,
       const int *stride);

namespace Setsudan
{
namespace
{
const char *const core_variable = "OPENBLAS_CORETYPE";

/** A function of OpenBLAS; nothing where the BLAS is another one. */
template <typename Function>
Function *
openblas(const char *const name)
{
  return reinterpret_cast<Function *>(dlsym(RTLD_DEFAULT, name));
}
} // namespace


std::string
blas_core()
{
  const auto name = openblas<char *()>("openblas_get_corename");
  return name != nullptr ? name() : "";
}



std::string
better_blas_core(const std::string &core, const InstructionSet processor)
{
  // All others are of processors without vectors of four numbers.
  static const std::map<std::string, InstructionSet> known = {
    {"Haswell", InstructionSet::avx2},
    {"Excavator", InstructionSet::avx2},
    {"Zen", InstructionSet::avx2},
    {"SkylakeX", InstructionSet::avx512},
    {"Cooperlake", InstructionSet::avx512},
    {"Sapphirerapids", InstructionSet::avx512}};
  const auto found = known.find(core);
  const InstructionSet used =
    found == known.end() ? InstructionSet::baseline : found->second;
  if (core.empty() || used >= processor)
    return "";
  return processor == InstructionSet::avx512 ? "SkylakeX" : "Haswell";
}



void
start_with_fitting_blas(char **argv)
{
  const std::string better = better_blas_core(blas_core(), instruction_set());
  if (better.empty() || std::getenv(core_variable) != nullptr)
    return;
  setenv(core_variable, better.c_str(), 0);
  // Busy waiting makes solves many times slower on a shared core.
  setenv("OMP_WAIT_POLICY", "passive", 0);
  setenv("OPENBLAS_THREAD_TIMEOUT", "4", 0);
  // Where that is not possible the program goes on, only slower.
  execv("/proc/self/exe", argv);
}



void
share_cores(const unsigned int n_processes_here)
{
  if (n_processes_here <= 1 || std::getenv("OPENBLAS_NUM_THREADS") != nullptr ||
      std::getenv("OMP_NUM_THREADS") != nullptr)
    return;
  const unsigned int n_cores = std::thread::hardware_concurrency();
  set_n_threads(std::max(1U, n_cores / n_processes_here));
}



unsigned int
n_threads()
{
  static const auto get = openblas<int()>("openblas_get_num_threads");
  return get != nullptr ? std::max(1, get()) : 1;
}



void
set_n_threads(const unsigned int n)
{
  static const auto set = openblas<void(int)>("openblas_set_num_threads");
  if (set != nullptr)
    set(n);
}



SingleThreadedBlas::SingleThreadedBlas()
  : n_before(n_threads())
{
  set_n_threads(1);
}



SingleThreadedBlas::~SingleThreadedBlas()
{
  set_n_threads(n_before);
}



void
solve_triangle(const double *l,
               const int n,
               const int stride,
               const bool transposed,
               double *x)
{
  const int one = 1;
  dtrsv_("L", transposed ? "T" : "N", "N", &n, l, &stride, x, &one);
}



std::string
describe_blas()
{
  const std::string core = blas_core();
  const unsigned int n   = n_threads();
  const std::string blas = core.empty() ? "a BLAS that is not OpenBLAS"
                                        : "OpenBLAS with kernels for " + core;
  return "Linear algebra: " + blas + ", " + std::to_string(n) +
         (n == 1 ? " thread" : " threads") + "; elements: kernels for " +
         stiffness_kernel<3>().name + ".";
}
} // namespace Setsudan
