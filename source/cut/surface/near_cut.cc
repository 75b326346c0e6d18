// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>

#include <setsudan/cut/surface/near_cut.h>
#include <setsudan/mesh/geometry.h>

#include <algorithm>
#include <set>

namespace Setsudan
{
using namespace dealii;

namespace
{
template <int dim>
std::set<CellFace>
faces_of_cuts(const CutParameters<dim> &cut)
{
  std::set<CellFace> faces;
  for (const auto &c : cut.cuts)
    for (const auto &face : c.surface.faces)
      faces.insert({face.minus, face.plus});
  return faces;
}



template <int dim>
Region<dim>
region_of_faces(const Body<dim> &body, const std::set<CellFace> &faces)
{
  Group group{"", 0, dim - 1, {}, {}};
  for (const auto &face : faces)
    group.entities.push_back(body.mesh.face_key(face));
  return Region<dim>(body, {&group});
}
} // namespace


template <int dim>
NearCut<dim>::NearCut(const Body<dim> &body,
                      const CutParameters<dim> &cut,
                      const double width)
  : body(body)
  , on_cut(region_of_faces(body, faces_of_cuts(cut)))
  , width(width)
  // Layers of elements lie where sums of lengths put them, up to round-off.
  , neighborhood(body, faces_of_cuts(cut), width * (1 + 1e-6))
{
}



template <int dim>
bool
NearCut<dim>::any_vertex(
  const Cell &cell,
  const std::function<bool(const CellPath &, const Point<dim> &)> &has) const
{
  const CellPath path = path_of_cell<dim>(cell);
  for (const unsigned int v : cell->vertex_indices())
    if (has(
          path,
          point_in_element<dim>(path, GeometryInfo<dim>::unit_cell_vertex(v))))
      return true;
  return false;
}



template <int dim>
bool
NearCut<dim>::touches(const Cell &cell) const
{
  return any_vertex(cell, [&](const CellPath &path, const Point<dim> &point) {
    return on_cut.contains(body, path.element, point);
  });
}



template <int dim>
bool
NearCut<dim>::is_near(const Cell &cell) const
{
  return touches(cell) ||
         (width > 0 &&
          any_vertex(cell, [&](const CellPath &path, const Point<dim> &point) {
            return neighborhood.contains(
              point_of_element(body.mesh.node_positions(path.element), point));
          }));
}



template <int dim>
Refinement
refine_near_cuts(const Body<dim> &body,
                 const CutParameters<dim> &cut,
                 const unsigned int global_levels,
                 const MPI_Comm communicator)
{
  if (cut.near_cut_levels == 0 || cut.cuts.empty())
    return {global_levels, {}};
  const NearCut<dim> near_cut(body, cut, cut.near_cut_width);
  parallel::distributed::Triangulation<dim> triangulation(communicator);
  create_triangulation(body.mesh, triangulation);
  triangulation.refine_global(global_levels);
  for (unsigned int l = 0; l < cut.near_cut_levels; ++l)
    {
      const int level = global_levels + l;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && cell->level() == level &&
            near_cut.is_near(cell))
          cell->set_refine_flag();
      triangulation.execute_coarsening_and_refinement();
    }
  return record_refinement(triangulation, global_levels);
}



namespace
{
/** Refine the cells that touch a cut until they are of one level. */
template <int dim>
void
level_at_cuts(const NearCut<dim> &near_cut,
              parallel::distributed::Triangulation<dim> &triangulation)
{
  const MPI_Comm communicator = triangulation.get_communicator();
  for (bool changed = true; changed;)
    {
      int highest = 0;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && near_cut.touches(cell))
          highest = std::max(highest, cell->level());
      highest = Utilities::MPI::max(highest, communicator);
      changed = false;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && cell->level() < highest &&
            near_cut.touches(cell))
          {
            cell->set_refine_flag();
            changed = true;
          }
      changed = Utilities::MPI::logical_or(changed, communicator);
      if (changed)
        triangulation.execute_coarsening_and_refinement();
    }
}
} // namespace


template <int dim>
Refinement
refine_further(const Body<dim> &body,
               const CutParameters<dim> &cut,
               const Refinement &refinement,
               const std::vector<CellPath> &marked,
               const MPI_Comm communicator)
{
  const NearCut<dim> near_cut(body, cut, 0);
  parallel::distributed::Triangulation<dim> triangulation(communicator);
  create_triangulation(body.mesh, triangulation);
  refine<dim>(triangulation, refinement);
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned() && std::binary_search(marked.begin(),
                                                       marked.end(),
                                                       path_of_cell<dim>(cell)))
      cell->set_refine_flag();
  triangulation.execute_coarsening_and_refinement();
  level_at_cuts(near_cut, triangulation);
  return record_refinement(triangulation, refinement.global_levels);
}



template class NearCut<2>;
template class NearCut<3>;
template Refinement
refine_near_cuts(const Body<2> &,
                 const CutParameters<2> &,
                 const unsigned int,
                 const MPI_Comm);
template Refinement
refine_near_cuts(const Body<3> &,
                 const CutParameters<3> &,
                 const unsigned int,
                 const MPI_Comm);
template Refinement
refine_further(const Body<2> &,
               const CutParameters<2> &,
               const Refinement &,
               const std::vector<CellPath> &,
               const MPI_Comm);
template Refinement
refine_further(const Body<3> &,
               const CutParameters<3> &,
               const Refinement &,
               const std::vector<CellPath> &,
               const MPI_Comm);
} // namespace Setsudan
