// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/kernel/instruction_set.h>
#include <setsudan/kernel/stiffness_kernel.h>

namespace Setsudan
{
// Each is compiled from batch_kernel.cc with the flags of its kind (see
// CMakeLists.txt).
#define SETSUDAN_DECLARE(kind)               \
  namespace kind                             \
  {                                          \
  template <int dim>                         \
  const StiffnessKernel<dim> &               \
  kernel();                                  \
  extern template const StiffnessKernel<2> & \
  kernel();                                  \
  extern template const StiffnessKernel<3> & \
  kernel();                                  \
  }

SETSUDAN_DECLARE(baseline)
#ifdef SETSUDAN_X86_KERNELS
SETSUDAN_DECLARE(avx2)
SETSUDAN_DECLARE(avx512)
#endif
#undef SETSUDAN_DECLARE


template <int dim>
const StiffnessKernel<dim> &
stiffness_kernel()
{
#ifdef SETSUDAN_X86_KERNELS
  if (instruction_set() == InstructionSet::avx512)
    return avx512::kernel<dim>();
  if (instruction_set() == InstructionSet::avx2)
    return avx2::kernel<dim>();
#endif
  return baseline::kernel<dim>();
}



template const StiffnessKernel<2> &
stiffness_kernel();
template const StiffnessKernel<3> &
stiffness_kernel();
} // namespace Setsudan
