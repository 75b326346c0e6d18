// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/body.h>

#include <string>
#include <vector>

namespace Setsudan
{
/** Places of a body at which something is found: how many there are, and the
 * vertices of the first one. */
struct FoundPlaces
{
  unsigned int n = 0;
  std::vector<unsigned int> vertices;
};

/** Where a body touches itself without being joined face to face. */
struct Joints
{
  /** Parts of the body: elements that share faces belong together. */
  unsigned int n_parts = 1;
  /** Places of several vertices. */
  FoundPlaces coincident;
  /** Faces of the surface that lie on others with other nodes. */
  FoundPlaces overlapping;
  /** Vertices that parts share which share no face. */
  FoundPlaces thin;
};

/** Look for such places. A box has none. */
template <int dim>
Joints
find_joints(const Body<dim> &body);

/** What was found, in sentences; none where there is nothing. */
template <int dim>
std::vector<std::string>
describe_joints(const Body<dim> &body, const Joints &joints);
} // namespace Setsudan
