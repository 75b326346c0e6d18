#include <setsudan/output/element_order.h>
#include <setsudan/output/piece_mesh.h>

#include <iomanip>
#include <numeric>
#include <ostream>

namespace Setsudan
{
namespace
{
template <typename Values>
void
write_array(std::ostream &out,
            const std::string &type,
            const std::string &name,
            const unsigned int n_components,
            const Values &values)
{
  out << "<DataArray type=\"" << type << "\" Name=\"" << name
      << "\" NumberOfComponents=\"" << n_components << "\" format=\"ascii\">\n";
  for (unsigned int i = 0; i < values.size(); ++i)
    out << values[i] << ((i + 1) % n_components == 0 ? '\n' : ' ');
  out << "</DataArray>\n";
}
} // namespace



template <int dim>
void
write_piece_vtu(const PieceMesh<dim> &piece,
                const OutputDirectory &directory,
                const std::string &name)
{
  const unsigned int n_elements = piece.elements.size();
  std::vector<unsigned int> offsets(n_elements);
  for (unsigned int e = 0; e < n_elements; ++e)
    offsets[e] = (e + 1) * n_element_nodes<dim>;
  // VTK's quadratic quadrilateral and quadratic hexahedron.
  const std::vector<unsigned int> types(n_elements, dim == 2 ? 23 : 25);
  std::vector<unsigned int> node_numbers(piece.nodes.size());
  std::vector<unsigned int> element_numbers(n_elements);
  std::iota(node_numbers.begin(), node_numbers.end(), 0);
  std::iota(element_numbers.begin(), element_numbers.end(), 0);

  directory.write(name, [&](std::ostream &out) {
    out << std::setprecision(16)
        << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" "
           "version=\"0.1\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\""
        << piece.nodes.size() << "\" NumberOfCells=\"" << n_elements
        << "\">\n<Points>\n";
    write_array(out, "Float64", "Points", 3, coordinates(piece));
    out << "</Points>\n<Cells>\n";
    write_array(out,
                "UInt32",
                "connectivity",
                n_element_nodes<dim>,
                connectivity(piece, vtk_edges<dim>(), 0));
    write_array(out, "UInt32", "offsets", 1, offsets);
    write_array(out, "UInt8", "types", 1, types);
    out << "</Cells>\n<PointData>\n";
    write_array(out, "UInt32", "node", 1, node_numbers);
    write_array(out, "UInt32", "node_in_body", 1, piece.numbers_in_body);
    out << "</PointData>\n<CellData>\n";
    write_array(out, "UInt32", "element", 1, element_numbers);
    write_array(out, "UInt32", "element_in_body", 1, piece.elements_in_body);
    out << "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  });
}



template void
write_piece_vtu(const PieceMesh<2> &,
                const OutputDirectory &,
                const std::string &);
template void
write_piece_vtu(const PieceMesh<3> &,
                const OutputDirectory &,
                const std::string &);
} // namespace Setsudan
