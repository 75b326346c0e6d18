// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes that come apart, without the surgery.
#pragma once

#include <setsudan/mesh/coarse_mesh.h>

#include <map>
#include <set>

namespace Setsudan
{
/** Give the cells `own` vertices of their own. */
template <int dim>
CoarseMesh<dim>
detach(CoarseMesh<dim> mesh, const std::set<unsigned int> &own)
{
  std::map<unsigned int, unsigned int> copies;
  for (const unsigned int cell : own)
    for (unsigned int &vertex : mesh.cells[cell].vertices)
      {
        const auto [copy, is_new] =
          copies.emplace(vertex, mesh.vertices.size());
        if (is_new)
          mesh.vertices.push_back(mesh.vertices[vertex]);
        vertex = copy->second;
      }
  return mesh;
}
} // namespace Setsudan
