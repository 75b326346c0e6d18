// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

namespace Setsudan
{
/**
 * From now on SIGINT (Ctrl-C) and SIGTERM do not end the program at once: they
 * are noted for interrupted(). A second one of a kind ends it.
 */
void
note_interruptions();

/** Whether any process has been told to stop. Called by all of them. */
bool
interrupted(const MPI_Comm communicator);
} // namespace Setsudan
