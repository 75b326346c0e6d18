#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace Setsudan
{
/** Numbers of points, one after the other. */
struct VtuArray
{
  std::string name;
  unsigned int n_components;
  std::vector<float> values;
};

/**
 * Cells of one kind for a VTK file of an unstructured grid. No two cells share
 * a point, so that what jumps between cells can be shown.
 */
struct VtuCells
{
  /** VTK's number of the kind. */
  unsigned char type;
  /** The points of a cell in VTK's order, by their places in ours. */
  std::vector<unsigned int> order;
  /** Three coordinates of each point, cell by cell. */
  std::vector<float> points;
  std::vector<VtuArray> data;

  unsigned int
  n_cells() const;
};

/** Write a .vtu file, compressed for speed; the binary data come behind the
 * text, as they are. */
void
write_vtu(const VtuCells &cells, std::ostream &out);

/** Write the .pvtu file of several of them with the same data. */
void
write_pvtu(const VtuCells &cells,
           const std::vector<std::string> &files,
           std::ostream &out);
} // namespace Setsudan
