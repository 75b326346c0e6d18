// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>

#include <setsudan/mesh/refinement.h>

#include <algorithm>
#include <set>

namespace Setsudan
{
using namespace dealii;

template <int dim>
CellPath
path_of_cell(const typename Triangulation<dim>::cell_iterator &cell)
{
  CellPath result;
  std::uint64_t digits = 0;
  unsigned int shift   = 0;
  auto ancestor        = cell;
  while (ancestor->level() > 0)
    {
      const auto parent  = ancestor->parent();
      unsigned int child = 0;
      while (parent->child(child) != ancestor)
        ++child;
      digits |= std::uint64_t(child) << shift;
      shift += dim;
      ancestor = parent;
    }
  result.element = ancestor->index();
  result.path    = digits | (std::uint64_t(1) << shift);
  return result;
}



template <int dim>
Point<dim>
point_in_element(const CellPath &path, const Point<dim> &unit_point)
{
  Point<dim> point = unit_point;
  for (std::uint64_t digits = path.path; digits > 1; digits >>= dim)
    point = GeometryInfo<dim>::child_to_cell_coordinates(
      point,
      static_cast<unsigned int>(
        digits & (GeometryInfo<dim>::max_children_per_cell - 1)));
  return point;
}



std::vector<CellPath>
gather_cells(const std::vector<CellPath> &own, const MPI_Comm communicator)
{
  std::set<CellPath> all;
  for (const auto &part : Utilities::MPI::all_gather(communicator, own))
    all.insert(part.begin(), part.end());
  return {all.begin(), all.end()};
}



template <int dim>
Refinement
record_refinement(const Triangulation<dim> &triangulation,
                  const unsigned int global_levels)
{
  std::set<CellPath> own;
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        CellPath path = path_of_cell<dim>(cell);
        for (int level = cell->level(); level > int(global_levels); --level)
          {
            path.path >>= dim;
            own.insert(path);
          }
      }
  return {
    global_levels,
    gather_cells({own.begin(), own.end()}, triangulation.get_communicator())};
}



template <int dim>
void
refine(Triangulation<dim> &triangulation, const Refinement &refinement)
{
  triangulation.refine_global(refinement.global_levels);
  bool changed = !refinement.refined.empty();
  while (changed)
    {
      changed = false;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() &&
            std::binary_search(refinement.refined.begin(),
                               refinement.refined.end(),
                               path_of_cell<dim>(cell)))
          {
            cell->set_refine_flag();
            changed = true;
          }
      changed =
        Utilities::MPI::logical_or(changed, triangulation.get_communicator());
      if (changed)
        triangulation.execute_coarsening_and_refinement();
    }
}



template <int dim>
types::global_cell_index
count_cells(const CoarseMesh<dim> &mesh, const Refinement &refinement)
{
  constexpr types::global_cell_index n_children =
    GeometryInfo<dim>::max_children_per_cell;
  return mesh.cells.size() *
           Utilities::pow(n_children, refinement.global_levels) +
         (n_children - 1) * refinement.refined.size();
}



template types::global_cell_index
count_cells(const CoarseMesh<2> &, const Refinement &);
template types::global_cell_index
count_cells(const CoarseMesh<3> &, const Refinement &);
template CellPath
path_of_cell<2>(const Triangulation<2>::cell_iterator &);
template CellPath
path_of_cell<3>(const Triangulation<3>::cell_iterator &);
template Point<2>
point_in_element(const CellPath &, const Point<2> &);
template Point<3>
point_in_element(const CellPath &, const Point<3> &);
template Refinement
record_refinement(const Triangulation<2> &, const unsigned int);
template Refinement
record_refinement(const Triangulation<3> &, const unsigned int);
template void
refine(Triangulation<2> &, const Refinement &);
template void
refine(Triangulation<3> &, const Refinement &);
} // namespace Setsudan
