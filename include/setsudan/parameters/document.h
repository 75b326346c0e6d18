// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/parameters/parameters.h>

#include <iosfwd>

namespace Setsudan
{
/**
 * Write the declared parameters as tables in Markdown, one per subsection:
 * name, default value, what is allowed, and the documentation.
 */
void
document_parameters(const Parameters::Declare &declare, std::ostream &out);
} // namespace Setsudan
