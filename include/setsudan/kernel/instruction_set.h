// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace Setsudan
{
/** What a processor's vector registers can do, from the least to the most. */
enum class InstructionSet
{
  baseline,
  avx2,
  avx512
};

/** The best that this processor has. */
InstructionSet
instruction_set();
} // namespace Setsudan
