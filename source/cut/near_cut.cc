#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>

#include <setsudan/body/geometry.h>
#include <setsudan/body/region.h>
#include <setsudan/cut/near_cut.h>
#include <setsudan/cut/neighborhood.h>

#include <algorithm>
#include <set>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Refines a mesh of the uncut body, and keeps the record. */
template <int dim>
class Refiner
{
public:
  using Cell = typename Triangulation<dim>::active_cell_iterator;

  Refiner(const Body<dim> &body,
          const CutParameters<dim> &cut,
          const unsigned int global_levels,
          const MPI_Comm communicator)
    : body(body)
    , communicator(communicator)
    , triangulation(communicator)
    , faces(faces_of_cuts(cut))
    , cut_region(region_of_faces(body, faces))
    , neighborhood(body, faces, cut.near_cut_width)
    , has_width(cut.near_cut_width > 0)
  {
    create_triangulation(body.mesh, triangulation);
    triangulation.refine_global(global_levels);
  }

  void
  refine_once(const int level)
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && cell->level() == level && is_near(cell))
        cell->set_refine_flag();
    triangulation.execute_coarsening_and_refinement();
  }

  /** The cells that are refined below the first levels. */
  std::vector<CellPath>
  record(const unsigned int global_levels) const
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
    std::set<CellPath> all;
    for (const auto &part : Utilities::MPI::all_gather(
           communicator, std::vector<CellPath>(own.begin(), own.end())))
      all.insert(part.begin(), part.end());
    return {all.begin(), all.end()};
  }

private:
  static std::set<CellFace>
  faces_of_cuts(const CutParameters<dim> &cut)
  {
    std::set<CellFace> faces;
    for (const auto &c : cut.cuts)
      for (const auto &face : c.surface.faces)
        faces.insert({face.minus, face.plus});
    return faces;
  }

  static Region<dim>
  region_of_faces(const Body<dim> &body, const std::set<CellFace> &faces)
  {
    Group group{"", 0, dim - 1, {}, {}};
    for (const auto &face : faces)
      group.entities.push_back(body.mesh.face_key(face));
    return Region<dim>(body, {&group});
  }

  bool
  is_near(const Cell &cell) const
  {
    // Also a cell that touches the cut in a line or a vertex only: so all cells
    // at a cut have the same level, and none of its nodes hangs.
    const CellPath path = path_of_cell<dim>(cell);
    const auto nodes    = body.mesh.node_positions(path.element);
    for (const unsigned int v : cell->vertex_indices())
      {
        const auto point =
          point_in_element<dim>(path, GeometryInfo<dim>::unit_cell_vertex(v));
        if (cut_region.contains(body, path.element, point) ||
            (has_width &&
             neighborhood.contains(point_of_element(nodes, point))))
          return true;
      }
    return false;
  }

  const Body<dim> &body;
  const MPI_Comm communicator;
  parallel::distributed::Triangulation<dim> triangulation;
  const std::set<CellFace> faces;
  /** The faces with their lines and vertices. */
  const Region<dim> cut_region;
  const Neighborhood<dim> neighborhood;
  const bool has_width;
};
} // namespace


template <int dim>
Refinement
refine_near_cuts(const Body<dim> &body,
                 const CutParameters<dim> &cut,
                 const unsigned int global_levels,
                 const MPI_Comm communicator)
{
  Refinement refinement{global_levels, {}};
  if (cut.near_cut_levels == 0 || cut.cuts.empty())
    return refinement;
  Refiner<dim> refiner(body, cut, global_levels, communicator);
  for (unsigned int level = 0; level < cut.near_cut_levels; ++level)
    refiner.refine_once(global_levels + level);
  refinement.refined = refiner.record(global_levels);
  return refinement;
}



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
} // namespace Setsudan
