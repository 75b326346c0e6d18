// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/body.h>
#include <setsudan/parameters/parameters.h>

#include <string>

namespace Setsudan
{
/**
 * The number of a node that a word in a parameter means.
 *
 * @throw SceneError where it is no number, or that of no node of the model.
 */
template <int dim>
unsigned int
node_of_word(const Parameters &parameters,
             const std::string &subsection,
             const std::string &name,
             const Body<dim> &body,
             const std::string &word);
} // namespace Setsudan
