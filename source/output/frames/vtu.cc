// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <setsudan/output/frames/vtu.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <ostream>
#include <string>

#include <libdeflate.h>

namespace Setsudan
{
using namespace dealii;

namespace
{
constexpr char byte_order[] =
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
  "LittleEndian";
#else
  "BigEndian";
#endif

/** The data behind the text, which names them by where they begin. */
class AppendedData
{
public:
  /** @return where they begin. */
  template <typename Number>
  std::size_t
  add(const std::vector<Number> &values)
  {
    const std::size_t begin = data.size();
    append(reinterpret_cast<const char *>(values.data()),
           values.size() * sizeof(Number));
    return begin;
  }

  std::string data;

private:
  /** For speed: files that are a tenth smaller would take twice as long. */
  const std::unique_ptr<libdeflate_compressor,
                        void (*)(libdeflate_compressor *)>
    compressor{libdeflate_alloc_compressor(1), libdeflate_free_compressor};

  /** VTK's blocks: how many there are, how large before they were compressed,
   * how large the last one if it is smaller, and each one's size. */
  void
  append(const char *const bytes, const std::size_t size)
  {
    constexpr std::size_t block_size = 1 << 20;
    const std::size_t n_blocks       = (size + block_size - 1) / block_size;
    std::vector<std::uint32_t> header{
      static_cast<std::uint32_t>(n_blocks),
      block_size,
      static_cast<std::uint32_t>(size % block_size)};
    std::string blocks;
    for (std::size_t begin = 0; begin < size; begin += block_size)
      {
        const std::size_t n = std::min(block_size, size - begin);
        const std::size_t bound =
          libdeflate_zlib_compress_bound(compressor.get(), n);
        const std::size_t at = blocks.size();
        blocks.resize(at + bound);
        const std::size_t n_compressed = libdeflate_zlib_compress(
          compressor.get(), bytes + begin, n, &blocks[at], bound);
        AssertThrow(n_compressed > 0, ExcInternalError());
        blocks.resize(at + n_compressed);
        header.push_back(n_compressed);
      }
    data.append(reinterpret_cast<const char *>(header.data()),
                header.size() * sizeof(header[0]));
    data += blocks;
  }
};



void
write_head(std::ostream &out, const std::string &type)
{
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type
      << "\" version=\"0.1\" byte_order=\"" << byte_order
      << "\" compressor=\"vtkZLibDataCompressor\">\n<" << type;
}

/** A text as an attribute of XML can hold it. */
std::string
escaped(const std::string &text)
{
  std::string result;
  for (const char c : text)
    result += c == '&'   ? "&amp;"
              : c == '<' ? "&lt;"
              : c == '"' ? "&quot;"
                         : std::string(1, c);
  return result;
}

const char *
name_of_type(const VtuArray::Values &values)
{
  constexpr const char *names[] = {"Float32", "Float64", "Int32"};
  return names[values.index()];
}

std::size_t
n_values(const VtuArray::Values &values)
{
  return std::visit([](const auto &list) { return list.size(); }, values);
}

std::string
description(const VtuArray &array)
{
  std::string text = std::string("DataArray type=\"") +
                     name_of_type(array.values) + "\" Name=\"" + array.name +
                     "\" NumberOfComponents=\"" +
                     std::to_string(array.n_components) + "\"";
  for (unsigned int c = 0; c < array.component_names.size(); ++c)
    text += " ComponentName" + std::to_string(c) + "=\"" +
            escaped(array.component_names[c]) + "\"";
  return text;
}

/** @param attributes that stand in the array's tag besides. */
void
write_array(const VtuArray &array,
            std::ostream &out,
            AppendedData &data,
            const std::string &attributes = "")
{
  const std::size_t begin = std::visit(
    [&](const auto &values) { return data.add(values); }, array.values);
  out << "<" << description(array) << attributes
      << " format=\"appended\" offset=\"" << begin << "\"/>\n";
}

void
write_arrays(const std::string &tag,
             const std::vector<VtuArray> &arrays,
             std::ostream &out,
             AppendedData &data)
{
  out << "<" << tag << ">\n";
  for (const auto &array : arrays)
    write_array(array, out, data);
  out << "</" << tag << ">\n";
}

void
write_field_data(const VtuGrid &grid, std::ostream &out, AppendedData &data)
{
  out << "<FieldData>\n";
  for (const auto &array : grid.field_data)
    write_array(array,
                out,
                data,
                " NumberOfTuples=\"" +
                  std::to_string(n_values(array.values) / array.n_components) +
                  "\"");
  out << "</FieldData>\n";
}

void
write_cells(const VtuGrid &grid, std::ostream &out, AppendedData &data)
{
  const std::size_t n_cells = grid.connectivity.size() / grid.n_points_of_cell;
  std::vector<std::int32_t> offsets(n_cells);
  for (std::size_t cell = 0; cell < n_cells; ++cell)
    offsets[cell] = (cell + 1) * grid.n_points_of_cell;
  out << "<Cells>\n";
  write_array({"connectivity", 1, grid.connectivity}, out, data);
  write_array({"offsets", 1, offsets}, out, data);
  out << "<DataArray type=\"UInt8\" Name=\"types\" format=\"appended\" "
         "offset=\""
      << data.add(std::vector<unsigned char>(n_cells, grid.type))
      << "\"/>\n</Cells>\n";
}
} // namespace



void
write_vtu(const VtuGrid &grid, std::ostream &out)
{
  AppendedData data;
  write_head(out, "UnstructuredGrid");
  out << ">\n";
  write_field_data(grid, out, data);
  out << "<Piece NumberOfPoints=\"" << n_values(grid.points) / 3
      << "\" NumberOfCells=\""
      << grid.connectivity.size() / grid.n_points_of_cell << "\">\n<Points>\n";
  write_array({"Points", 3, grid.points}, out, data);
  out << "</Points>\n";
  write_cells(grid, out, data);
  write_arrays("PointData", grid.point_data, out, data);
  write_arrays("CellData", grid.cell_data, out, data);
  out << "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_"
      << data.data << "\n</AppendedData>\n</VTKFile>\n";
}



void
write_pvtu(const VtuGrid &grid,
           const std::vector<std::string> &files,
           std::ostream &out)
{
  write_head(out, "PUnstructuredGrid");
  out << " GhostLevel=\"0\">\n";
  const auto write_names = [&](const std::string &tag,
                               const std::vector<VtuArray> &arrays) {
    out << "<" << tag << ">\n";
    for (const auto &array : arrays)
      out << "<P" << description(array) << "/>\n";
    out << "</" << tag << ">\n";
  };
  write_names("PPointData", grid.point_data);
  write_names("PCellData", grid.cell_data);
  write_names("PPoints", {{"Points", 3, grid.points}});
  for (const auto &file : files)
    out << "<Piece Source=\"" << file << "\"/>\n";
  out << "</PUnstructuredGrid>\n</VTKFile>\n";
}
} // namespace Setsudan
