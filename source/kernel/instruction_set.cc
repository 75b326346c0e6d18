// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/kernel/instruction_set.h>

namespace Setsudan
{
InstructionSet
instruction_set()
{
#ifdef SETSUDAN_X86_KERNELS
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return InstructionSet::avx512;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return InstructionSet::avx2;
#endif
  return InstructionSet::baseline;
}
} // namespace Setsudan
