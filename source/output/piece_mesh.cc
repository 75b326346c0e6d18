#include <deal.II/grid/grid_tools.h>

#include <setsudan/output/piece_mesh.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** What tells nodes of a mesh apart, in the order of their numbers: first the
 * number in the uncut body, then the vertices between which it lies. */
using NodeName = std::tuple<unsigned int, unsigned int, unsigned int>;

template <int dim>
NodeName
name_of_node(const CoarseMesh<dim> &mesh,
             const Body<dim> &body,
             const unsigned int element,
             const unsigned int node)
{
  const auto ends          = vertices_of_node<dim>(node);
  const auto &vertices     = mesh.cells[element].vertices;
  const auto [first, last] = std::minmax(vertices[ends[0]], vertices[ends[1]]);
  return {body.numbering.node_number(element, node), first, last};
}
} // namespace


template <int dim>
double
PieceMesh<dim>::volume() const
{
  double volume = 0;
  for (const auto &element : elements)
    {
      const std::vector<unsigned int> vertices(
        element.begin(),
        element.begin() + GeometryInfo<dim>::vertices_per_cell);
      volume += GridTools::cell_measure<dim>(nodes, make_array_view(vertices));
    }
  return volume;
}



template <int dim>
std::vector<PieceMesh<dim>>
make_piece_meshes(const CoarseMesh<dim> &mesh,
                  const std::vector<unsigned int> &pieces,
                  const Body<dim> &body)
{
  std::vector<PieceMesh<dim>> meshes(
    *std::max_element(pieces.begin(), pieces.end()) + 1);
  std::vector<std::map<NodeName, unsigned int>> numbers(meshes.size());
  for (unsigned int element = 0; element < pieces.size(); ++element)
    {
      meshes[pieces[element]].elements_in_body.push_back(element);
      for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
        numbers[pieces[element]][name_of_node(mesh, body, element, node)];
    }
  for (unsigned int p = 0; p < meshes.size(); ++p)
    {
      unsigned int next = 0;
      for (auto &[name, number] : numbers[p])
        {
          number = next++;
          meshes[p].numbers_in_body.push_back(std::get<0>(name));
        }
      meshes[p].nodes.resize(next);
      for (const unsigned int element : meshes[p].elements_in_body)
        {
          auto &nodes = meshes[p].elements.emplace_back();
          for (unsigned int node = 0; node < nodes.size(); ++node)
            {
              nodes[node] =
                numbers[p].at(name_of_node(mesh, body, element, node));
              meshes[p].nodes[nodes[node]] = mesh.node_position(element, node);
            }
        }
    }
  return meshes;
}



template struct PieceMesh<2>;
template struct PieceMesh<3>;
template std::vector<PieceMesh<2>>
make_piece_meshes(const CoarseMesh<2> &,
                  const std::vector<unsigned int> &,
                  const Body<2> &);
template std::vector<PieceMesh<3>>
make_piece_meshes(const CoarseMesh<3> &,
                  const std::vector<unsigned int> &,
                  const Body<3> &);
} // namespace Setsudan
