#include <setsudan/body/nodes.h>
#include <setsudan/body/supports.h>
#include <setsudan/parameters/lists.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
void
SupportParameters<dim>::declare(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Support",
                    "Fixed faces",
                    "",
                    Patterns::Anything(),
                    "Faces whose nodes are held in all directions, separated "
                    "by commas: left, right (x min, max), front, back (y), "
                    "bottom, top (z; in 2D y).");
  Setsudan::declare(handler,
                    "Support",
                    "Fixed nodes",
                    "",
                    Patterns::List(Patterns::Integer(0)),
                    "Numbers of nodes that are held in all directions, counted "
                    "as in the paper: x fastest, then y, then z, from 0.");
}



template <int dim>
SupportParameters<dim>::SupportParameters(const Parameters &parameters,
                                          const Body<dim> &body)
{
  for (const auto &name : split(parameters.text("Support", "Fixed faces"), ','))
    {
      types::boundary_id id;
      parameters.require(find_face<dim>(name, id),
                         "Support",
                         "Fixed faces",
                         "a list of " + face_names<dim>());
      faces.insert(id);
    }
  for (const double node : parameters.numbers("Support", "Fixed nodes"))
    {
      parameters.require(node < body.numbering.n_nodes(),
                         "Support",
                         "Fixed nodes",
                         "node numbers from 0 to " +
                           std::to_string(body.numbering.n_nodes() - 1));
      nodes.insert(static_cast<unsigned int>(node));
    }
}



template <int dim>
Supports<dim>::Supports(const SupportParameters<dim> &parameters,
                        const Body<dim> &body)
  : parameters(parameters)
  , body(body)
{
}



template <int dim>
bool
Supports<dim>::is_fixed(const unsigned int cell, const unsigned int node) const
{
  if (!parameters.nodes.empty() &&
      parameters.nodes.count(body.numbering.node_number(cell, node)) > 0)
    return true;
  for (unsigned int face = 0; face < GeometryInfo<dim>::faces_per_cell; ++face)
    if (node_is_on_face<dim>(node, face))
      {
        const auto boundary = body.mesh.boundary_ids.find({cell, face});
        if (boundary != body.mesh.boundary_ids.end() &&
            parameters.faces.count(boundary->second) > 0)
          return true;
      }
  return false;
}



template <int dim>
std::vector<Point<dim>>
Supports<dim>::fixed_points(const std::vector<unsigned int> &cells) const
{
  std::vector<Point<dim>> points;
  for (const unsigned int cell : cells)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      if (is_fixed(cell, node))
        points.push_back(body.mesh.node_position(cell, node));
  return points;
}



template struct SupportParameters<2>;
template struct SupportParameters<3>;
template class Supports<2>;
template class Supports<3>;
} // namespace Setsudan
