#include <setsudan/cut/cut_surface.h>
#include <setsudan/parameters/lists.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
void
CutParameters<dim>::declare(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Cut",
                    "Surfaces",
                    "",
                    Patterns::Anything(),
                    "Where the body is divided, as 'axis : boundary', with "
                    "boundaries between layers of elements counted from 1; "
                    "several, separated by ';', are cut in turn. Without one "
                    "the scene is a deformation and nothing else.");
}



template <int dim>
CutParameters<dim>::CutParameters(const Parameters &parameters,
                                  const BodyParameters<dim> &body)
{
  const std::string axes = std::string("xyz").substr(0, dim);
  for (const auto &[axis, boundary] :
       split_items(parameters.text("Cut", "Surfaces"), ';'))
    {
      AxisCut cut{0, 0, axis + ":" + boundary};
      cut.axis = axes.find(axis);
      parameters.require(axis.size() == 1 && cut.axis < dim,
                         "Cut",
                         "Surfaces",
                         "'axis : boundary' with an axis of " + axes);
      const unsigned int n_layers = body.n_elements[cut.axis];
      std::vector<double> number;
      const bool valid = parse_numbers(boundary, number) &&
                         number.size() == 1 && number[0] >= 1 &&
                         number[0] <= n_layers - 1. &&
                         number[0] == static_cast<unsigned int>(number[0]);
      parameters.require(valid,
                         "Cut",
                         "Surfaces",
                         n_layers == 1
                           ? "no cut across " + axis +
                               ", where the body is one element thick"
                           : "for " + axis + " a boundary from 1 to " +
                               std::to_string(n_layers - 1));
      cut.boundary = static_cast<unsigned int>(number[0]);
      for (const auto &other : surfaces)
        parameters.require(other.axis != cut.axis ||
                             other.boundary != cut.boundary,
                           "Cut",
                           "Surfaces",
                           "each surface once");
      surfaces.push_back(cut);
    }
}



template <int dim>
CutSurface<dim>
make_cut_surface(const Body<dim> &body, const AxisCut &cut)
{
  CutSurface<dim> surface;
  for (unsigned int element = 0; element < body.mesh.cells.size(); ++element)
    {
      auto indices = body.numbering.element_indices(element);
      if (indices[cut.axis] != cut.boundary)
        continue;
      CutFace<dim> face;
      face.plus = {element, 2 * cut.axis};
      --indices[cut.axis];
      face.minus = {body.numbering.element_number(indices), 2 * cut.axis + 1};
      face.normal[cut.axis] = 1;
      surface.push_back(face);
    }
  return surface;
}



template struct CutParameters<2>;
template struct CutParameters<3>;
template CutSurface<2>
make_cut_surface(const Body<2> &, const AxisCut &);
template CutSurface<3>
make_cut_surface(const Body<3> &, const AxisCut &);
} // namespace Setsudan
