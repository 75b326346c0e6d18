#include <deal.II/base/exceptions.h>

#include <setsudan/output/piece_mesh.h>

#include <gmsh.h>

#include <iomanip>
#include <numeric>
#include <ostream>

namespace Setsudan
{
using namespace dealii;

namespace
{
using Edges = std::vector<std::array<unsigned int, 2>>;

/** Corners of a cell in the order of gmsh and VTK: around the bottom, then
 * around the top. */
template <int dim>
std::vector<unsigned int>
corner_order()
{
  if (dim == 2)
    return {0, 1, 3, 2};
  return {0, 1, 3, 2, 4, 5, 7, 6};
}

/** Edges between those corners, in VTK's order of mid-side nodes. */
template <int dim>
Edges
vtk_edges()
{
  Edges edges = {{{0, 1}}, {{1, 2}}, {{2, 3}}, {{3, 0}}};
  if (dim == 3)
    edges.insert(edges.end(),
                 {{{4, 5}},
                  {{5, 6}},
                  {{6, 7}},
                  {{7, 4}},
                  {{0, 4}},
                  {{1, 5}},
                  {{2, 6}},
                  {{3, 7}}});
  return edges;
}

/** The same in gmsh's order. */
template <int dim>
Edges
gmsh_edges()
{
  if (dim == 2)
    return vtk_edges<2>();
  return {{{0, 1}},
          {{0, 3}},
          {{0, 4}},
          {{1, 2}},
          {{1, 5}},
          {{2, 3}},
          {{2, 6}},
          {{3, 7}},
          {{4, 5}},
          {{4, 7}},
          {{5, 6}},
          {{6, 7}}};
}

/** For each node of another program's element its number in ours. */
template <int dim>
std::vector<unsigned int>
node_order(const Edges &edges)
{
  const auto corners = corner_order<dim>();
  auto order         = corners;
  for (const auto &edge : edges)
    for (unsigned int node = GeometryInfo<dim>::vertices_per_cell;
         node < n_element_nodes<dim>;
         ++node)
      {
        const auto ends      = vertices_of_node<dim>(node);
        const unsigned int a = corners[edge[0]], b = corners[edge[1]];
        if ((ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a))
          order.push_back(node);
      }
  AssertDimension(order.size(), n_element_nodes<dim>);
  return order;
}

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

/** The nodes' coordinates one behind the other, always three each. */
template <int dim>
std::vector<double>
coordinates(const PieceMesh<dim> &piece)
{
  std::vector<double> coordinates;
  for (const auto &node : piece.nodes)
    for (unsigned int d = 0; d < 3; ++d)
      coordinates.push_back(d < dim ? node[d % dim] : 0.);
  return coordinates;
}

/** The elements' nodes one behind the other, in another program's order. */
template <typename Number, int dim>
std::vector<Number>
connectivity(const PieceMesh<dim> &piece,
             const Edges &edges,
             const unsigned int first_number)
{
  const auto order = node_order<dim>(edges);
  std::vector<Number> nodes;
  for (const auto &element : piece.elements)
    for (const unsigned int node : order)
      nodes.push_back(element[node] + first_number);
  return nodes;
}
} // namespace


template <int dim>
void
write_piece_msh(const PieceMesh<dim> &piece,
                const OutputDirectory &directory,
                const std::string &name)
{
  std::vector<std::size_t> node_tags(piece.nodes.size());
  std::vector<std::size_t> element_tags(piece.elements.size());
  std::iota(node_tags.begin(), node_tags.end(), 1);
  std::iota(element_tags.begin(), element_tags.end(), 1);
  const int element_type = dim == 2 ? 16 : 17;

  gmsh::initialize();
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::model::add("piece");
  gmsh::model::addDiscreteEntity(dim, 1);
  gmsh::model::mesh::addNodes(dim, 1, node_tags, coordinates(piece));
  gmsh::model::mesh::addElementsByType(
    1,
    element_type,
    element_tags,
    connectivity<std::size_t>(piece, gmsh_edges<dim>(), 1));
  gmsh::model::addPhysicalGroup(dim, {1}, 1);
  gmsh::model::setPhysicalName(dim, 1, "piece");
  directory.write_file(
    name, [](const std::string &file_name) { gmsh::write(file_name); });
  gmsh::finalize();
}



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
                connectivity<unsigned int>(piece, vtk_edges<dim>(), 0));
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
write_piece_msh(const PieceMesh<2> &,
                const OutputDirectory &,
                const std::string &);
template void
write_piece_msh(const PieceMesh<3> &,
                const OutputDirectory &,
                const std::string &);
template void
write_piece_vtu(const PieceMesh<2> &,
                const OutputDirectory &,
                const std::string &);
template void
write_piece_vtu(const PieceMesh<3> &,
                const OutputDirectory &,
                const std::string &);
} // namespace Setsudan
