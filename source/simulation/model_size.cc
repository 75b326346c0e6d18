// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/mesh_size.h>
#include <setsudan/simulation/model_size.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The elements that have a face on a cut. */
template <int dim>
double
n_elements_at_cuts(const CutParameters<dim> &cut)
{
  std::set<unsigned int> elements;
  for (const auto &one : cut.cuts)
    for (const auto &face : one.surface.faces)
      elements.insert({face.minus.first, face.plus.first});
  return elements.size();
}
} // namespace



template <int dim>
ModelSize
estimate_size(const BodyParameters<dim> &shape,
              const Body<dim> &body,
              const CutParameters<dim> &cut,
              const SolverParameters &solver)
{
  const auto mesh =
    shape.refined(body.box ? size_of_box<dim>(body.box->n_elements)
                           : size_of_mesh(body.mesh));
  ModelSize size;
  size.n_cells = mesh.n_cells();
  // Of the children of a cell at a cut those of one side are at it.
  double n_at_cuts =
    n_elements_at_cuts(cut) * std::pow(2., (dim - 1.) * shape.refinement);
  for (unsigned int level = 0; level < cut.near_cut_levels; ++level)
    {
      size.n_cells += (Utilities::pow(2, dim) - 1) * n_at_cuts;
      n_at_cuts *= Utilities::pow(2, dim - 1);
    }
  size.n_unknowns =
    mesh.n_unknowns(shape.element_type) * size.n_cells / mesh.n_cells();
  const double most = std::numeric_limits<types::global_dof_index>::max();
  size.bytes =
    memory_of_model<dim>(size.n_unknowns,
                         solver.is_direct(static_cast<types::global_dof_index>(
                           std::min(size.n_unknowns, most))));
  return size;
}



template <int dim>
void
check_size(const Parameters &parameters,
           const BodyParameters<dim> &shape,
           const CutParameters<dim> &cut,
           const ModelSize &size)
{
  const bool is_near    = cut.near_cut_levels > 0;
  const bool is_refined = shape.refinement > 0;
  check_memory(parameters,
               is_near ? "Cut" : "Body",
               is_near      ? "Refinement near cut"
               : is_refined ? "Refinement"
               : shape.shape == BodyParameters<dim>::Shape::box ? "Elements"
                                                                : "File",
               size.n_cells,
               size.n_unknowns,
               size.bytes);
}



template ModelSize
estimate_size(const BodyParameters<2> &,
              const Body<2> &,
              const CutParameters<2> &,
              const SolverParameters &);
template void
check_size(const Parameters &,
           const BodyParameters<2> &,
           const CutParameters<2> &,
           const ModelSize &);
template ModelSize
estimate_size(const BodyParameters<3> &,
              const Body<3> &,
              const CutParameters<3> &,
              const SolverParameters &);
template void
check_size(const Parameters &,
           const BodyParameters<3> &,
           const CutParameters<3> &,
           const ModelSize &);
} // namespace Setsudan
