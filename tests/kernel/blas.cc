// SPDX-License-Identifier: LGPL-2.1-or-later
// Which kernels OpenBLAS shall take where its own choice is too old.

#include <setsudan/kernel/blas.h>

#include "../test_setup.h"

using namespace Setsudan;

void
print(const std::string &core, const InstructionSet processor)
{
  const std::string better = better_blas_core(core, processor);
  std::cout << "  " << (core.empty() ? "another BLAS" : core) << ": "
            << (better.empty() ? "stays" : better) << std::endl;
}


void
test()
{
  const std::vector<std::string> cores = {
    "Prescott", "Nehalem", "Haswell", "Zen", "SkylakeX", "Cooperlake", ""};
  const std::vector<std::pair<std::string, InstructionSet>> processors = {
    {"no vectors of four", InstructionSet::baseline},
    {"AVX2", InstructionSet::avx2},
    {"AVX-512", InstructionSet::avx512}};
  for (const auto &[name, processor] : processors)
    {
      std::cout << "A processor with " << name << std::endl;
      for (const auto &core : cores)
        print(core, processor);
    }
  // Where the choice is the user's, or good, this comes back.
  setenv("OPENBLAS_CORETYPE", "Prescott", 1);
  start_with_fitting_blas(nullptr);
  std::cout << "not started anew" << std::endl;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, test);
}
