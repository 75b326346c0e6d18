#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <setsudan/body/body.h>

#include <limits>

namespace Setsudan
{
using namespace dealii;

template <int dim>
void
BodyParameters<dim>::declare(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Body",
                    "Shape",
                    "box",
                    Patterns::Selection("box"),
                    "The shape of the body: a box from the origin to Size.");
  Setsudan::declare(
    handler,
    "Body",
    "Size",
    dim == 3 ? "10, 10, 10" : "10, 10",
    Patterns::List(Patterns::Double(), dim, dim),
    "Edge lengths of the box along the axes, greater than 0 [length].");
  Setsudan::declare(handler,
                    "Body",
                    "Elements",
                    dim == 3 ? "1, 2, 1" : "2, 1",
                    Patterns::List(Patterns::Integer(1), dim, dim),
                    "Number of elements along each axis: the paper's nx, ny "
                    "and nz, each at least 1.");
}



template <int dim>
BodyParameters<dim>::BodyParameters(const Parameters &parameters)
{
  const auto lengths = parameters.numbers("Body", "Size", dim);
  const auto counts  = parameters.numbers("Body", "Elements", dim);
  double n_cells     = 1;
  for (unsigned int d = 0; d < dim; ++d)
    {
      parameters.require(
        lengths[d] > 0, "Body", "Size", "lengths greater than 0");
      size[d]       = lengths[d];
      n_elements[d] = static_cast<unsigned int>(counts[d]);
      n_cells *= counts[d];
    }
  // Node numbers are 32 bits wide, and there are fewer than 5 nodes a cell.
  parameters.require(n_cells < std::numeric_limits<unsigned int>::max() / 8.,
                     "Body",
                     "Elements",
                     "fewer than 500 million elements in all");
}



template <int dim>
Body<dim>::Body(const BodyParameters<dim> &parameters)
  : numbering(parameters.n_elements)
{
  Triangulation<dim> box;
  GridGenerator::subdivided_hyper_rectangle(
    box,
    std::vector<unsigned int>(parameters.n_elements.begin(),
                              parameters.n_elements.end()),
    Point<dim>(),
    parameters.size,
    true);
  SubCellData boundary_description;
  std::tie(mesh.vertices, mesh.cells, boundary_description) =
    GridTools::get_coarse_mesh_description(box);
  for (const auto &cell : box.active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
      if (cell->face(face)->at_boundary())
        mesh.boundary_ids[{cell->index(), face}] =
          cell->face(face)->boundary_id();
}



namespace
{
// In the order of deal.II's boundary ids for a box.
template <int dim>
std::vector<std::string>
list_of_faces()
{
  if (dim == 2)
    return {"left", "right", "bottom", "top"};
  return {"left", "right", "front", "back", "bottom", "top"};
}
} // namespace


template <int dim>
bool
find_face(const std::string &name, types::boundary_id &id)
{
  const auto names = list_of_faces<dim>();
  for (id = 0; id < names.size(); ++id)
    if (names[id] == name)
      return true;
  return false;
}



template <int dim>
std::string
face_names()
{
  std::string text;
  for (const auto &name : list_of_faces<dim>())
    text += (text.empty() ? "" : ", ") + name;
  return text;
}



template struct BodyParameters<2>;
template struct BodyParameters<3>;
template struct Body<2>;
template struct Body<3>;
template bool
find_face<2>(const std::string &, types::boundary_id &);
template bool
find_face<3>(const std::string &, types::boundary_id &);
template std::string
face_names<2>();
template std::string
face_names<3>();
} // namespace Setsudan
