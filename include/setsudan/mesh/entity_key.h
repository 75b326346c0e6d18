// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/types.h>

#include <algorithm>
#include <array>

namespace Setsudan
{
/**
 * A vertex, line or face of a mesh, named by its vertices: their numbers in
 * ascending order, filled up with `invalid_unsigned_int`. It is the same from
 * every cell that has the entity.
 */
using EntityKey = std::array<unsigned int, 4>;

/** The key of an entity by its vertices, in any order; at most 4. */
template <typename Vertices>
EntityKey
make_entity_key(const Vertices &vertices)
{
  EntityKey key;
  key.fill(dealii::numbers::invalid_unsigned_int);
  std::copy(vertices.begin(), vertices.end(), key.begin());
  std::sort(key.begin(), key.end());
  return key;
}

/** The number of vertices that a key names. */
inline unsigned int
n_vertices(const EntityKey &key)
{
  return std::count_if(key.begin(), key.end(), [](const unsigned int vertex) {
    return vertex != dealii::numbers::invalid_unsigned_int;
  });
}
} // namespace Setsudan
