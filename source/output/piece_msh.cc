#include <setsudan/output/element_order.h>
#include <setsudan/output/piece_mesh.h>

#include <gmsh.h>

#include <numeric>

namespace Setsudan
{
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
    1, element_type, element_tags, connectivity(piece, gmsh_edges<dim>(), 1));
  gmsh::model::addPhysicalGroup(dim, {1}, 1);
  gmsh::model::setPhysicalName(dim, 1, "piece");
  directory.write_file(
    name, [](const std::string &file_name) { gmsh::write(file_name); });
  gmsh::finalize();
}



template void
write_piece_msh(const PieceMesh<2> &,
                const OutputDirectory &,
                const std::string &);
template void
write_piece_msh(const PieceMesh<3> &,
                const OutputDirectory &,
                const std::string &);
} // namespace Setsudan
