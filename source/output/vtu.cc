#include <deal.II/base/exceptions.h>

#include <setsudan/output/vtu.h>

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



std::string
description(const std::string &type,
            const std::string &name,
            const unsigned int n_components)
{
  return "DataArray type=\"" + type + "\" Name=\"" + name +
         "\" NumberOfComponents=\"" + std::to_string(n_components) + "\"";
}



template <typename Number>
void
write_array(const std::string &type,
            const std::string &name,
            const unsigned int n_components,
            const std::vector<Number> &values,
            std::ostream &out,
            AppendedData &data)
{
  out << "<" << description(type, name, n_components)
      << " format=\"appended\" offset=\"" << data.add(values) << "\"/>\n";
}



void
write_connectivity(const VtuCells &cells, std::ostream &out, AppendedData &data)
{
  const unsigned int n_points = cells.order.size();
  std::vector<std::int32_t> connectivity, offsets;
  for (unsigned int cell = 0; cell < cells.n_cells(); ++cell)
    {
      for (const unsigned int place : cells.order)
        connectivity.push_back(cell * n_points + place);
      offsets.push_back(connectivity.size());
    }
  out << "<Cells>\n";
  write_array("Int32", "connectivity", 1, connectivity, out, data);
  write_array("Int32", "offsets", 1, offsets, out, data);
  write_array("UInt8",
              "types",
              1,
              std::vector<unsigned char>(offsets.size(), cells.type),
              out,
              data);
  out << "</Cells>\n";
}
} // namespace


unsigned int
VtuCells::n_cells() const
{
  return points.size() / 3 / order.size();
}



void
write_vtu(const VtuCells &cells, std::ostream &out)
{
  AppendedData data;
  write_head(out, "UnstructuredGrid");
  out << ">\n<Piece NumberOfPoints=\"" << cells.points.size() / 3
      << "\" NumberOfCells=\"" << cells.n_cells() << "\">\n<Points>\n";
  write_array("Float32", "Points", 3, cells.points, out, data);
  out << "</Points>\n";
  write_connectivity(cells, out, data);
  out << "<PointData>\n";
  for (const auto &[name, n_components, values] : cells.data)
    write_array("Float32", name, n_components, values, out, data);
  out << "</PointData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData "
         "encoding=\"raw\">\n_"
      << data.data << "\n</AppendedData>\n</VTKFile>\n";
}



void
write_pvtu(const VtuCells &cells,
           const std::vector<std::string> &files,
           std::ostream &out)
{
  write_head(out, "PUnstructuredGrid");
  out << " GhostLevel=\"0\">\n";
  const auto write_names = [&](const std::string &tag,
                               const std::vector<VtuArray> &arrays) {
    out << "<" << tag << ">\n";
    for (const auto &array : arrays)
      out << "<P" << description("Float32", array.name, array.n_components)
          << "/>\n";
    out << "</" << tag << ">\n";
  };
  write_names("PPointData", cells.data);
  write_names("PPoints", {{"Points", 3, {}}});
  for (const auto &file : files)
    out << "<Piece Source=\"" << file << "\"/>\n";
  out << "</PUnstructuredGrid>\n</VTKFile>\n";
}
} // namespace Setsudan
