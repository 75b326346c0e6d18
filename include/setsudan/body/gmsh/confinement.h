// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace Setsudan
{
/**
 * From now on this process can neither start others nor change files, make
 * connections, or open files but for reading: what is tried of that fails as on
 * a disk that is read-only, and a command kills the process by SIGSYS. There is
 * no way back.
 *
 * @return whether this system can do so; where it cannot, nothing has changed.
 */
bool
confine_process();
} // namespace Setsudan
