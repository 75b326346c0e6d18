// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/body.h>
#include <setsudan/parameters/parameters.h>

#include <string>
#include <vector>

namespace Setsudan
{
/** Which groups a parameter is for. */
enum class GroupKind
{
  /** Groups of elements. */
  elements,
  /** Groups of faces. */
  faces,
  /** Groups of faces, or where a word means none of these, the one group of
   * another dimension that it means: its nodes are taken. */
  faces_or_nodes
};

/**
 * The group that a word in a parameter means: the one of the kind that has the
 * word as its name or as its number.
 *
 * @throw SceneError where there is none, where there are several, and where the
 * group has no parts.
 */
template <int dim>
const Group &
find_group_or_reject(const Parameters &parameters,
                     const std::string &subsection,
                     const std::string &name,
                     const Body<dim> &body,
                     const std::string &word,
                     const GroupKind kind);
} // namespace Setsudan
