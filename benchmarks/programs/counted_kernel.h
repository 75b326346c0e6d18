// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/kernel/stiffness_kernel.h>

/** The floating point operations that K u takes for one cell of a batch of
 * serendipity elements in space: those of the kernel's own source, run on
 * numbers that count what is done to them. */
double
counted_operations(const Setsudan::CellBatch &batch);
