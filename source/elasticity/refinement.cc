#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <setsudan/elasticity/refinement.h>

#include <algorithm>

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



template CellPath
path_of_cell<2>(const Triangulation<2>::cell_iterator &);
template CellPath
path_of_cell<3>(const Triangulation<3>::cell_iterator &);
template Point<2>
point_in_element(const CellPath &, const Point<2> &);
template Point<3>
point_in_element(const CellPath &, const Point<3> &);
template void
refine(Triangulation<2> &, const Refinement &);
template void
refine(Triangulation<3> &, const Refinement &);
} // namespace Setsudan
