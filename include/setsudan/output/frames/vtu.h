// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <variant>
#include <vector>

namespace Setsudan
{
/** An array of a VTK file, tuple by tuple. */
struct VtuArray
{
  using Values = std::
    variant<std::vector<float>, std::vector<double>, std::vector<std::int32_t>>;

  std::string name;
  unsigned int n_components;
  Values values;
  /** A name for each component, or none. */
  std::vector<std::string> component_names = {};
};

/** Cells of one kind, for a VTK file of an unstructured grid. */
struct VtuGrid
{
  /** VTK's number of the kind. */
  unsigned char type;
  unsigned int n_points_of_cell;
  /** Three coordinates of each point. */
  VtuArray::Values points;
  /** The points of the cells, one cell after the other, in VTK's order. */
  std::vector<std::int32_t> connectivity;
  std::vector<VtuArray> point_data, cell_data;
  /** What is said of the grid as a whole. Texts are names of components: not
   * all readers take arrays of strings. */
  std::vector<VtuArray> field_data;
};

/** Symmetric tensors have VTK's order of components. */
const std::vector<std::string> symmetric_components =
  {"XX", "YY", "ZZ", "XY", "YZ", "XZ"};

/** Write a .vtu file, compressed for speed; the binary data come behind the
 * text, as they are. */
void
write_vtu(const VtuGrid &grid, std::ostream &out);

/** Write the .pvtu file of several of them with the same data. */
void
write_pvtu(const VtuGrid &grid,
           const std::vector<std::string> &files,
           std::ostream &out);
} // namespace Setsudan
