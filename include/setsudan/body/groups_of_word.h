#pragma once

#include <setsudan/body/body.h>
#include <setsudan/parameters/parameters.h>

#include <string>
#include <vector>

namespace Setsudan
{
/**
 * The groups that a word in a parameter means.
 *
 * @throw SceneError where there is none, or where it has no parts.
 */
template <int dim>
std::vector<const Group *>
groups_of_word(const Parameters &parameters,
               const std::string &subsection,
               const std::string &name,
               const Body<dim> &body,
               const std::string &word);
} // namespace Setsudan
