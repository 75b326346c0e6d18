// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/seam/sides.h>
#include <setsudan/cut/surface/mesh_surgery.h>
#include <setsudan/cut/surface/near_cut.h>
#include <setsudan/mesh/pieces.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/simulation/cut_body.h>
#include <setsudan/space/transfer.h>

#include <algorithm>
#include <set>

namespace Setsudan
{
using namespace dealii;

template <int dim>
CutBody<dim>::CutBody(const Scene<dim> &scene,
                      const Refinement &refinement,
                      const MPI_Comm communicator)
  : the_scene(scene)
  , materials(scene.material)
  , mpi_communicator(communicator)
  , the_refinement(refinement)
  , present_mesh(scene.body.mesh)
  , selection(scene.solver)
  , element_labels{std::vector<int>(scene.body.mesh.cells.size(), 0),
                   find_pieces(scene.body.mesh)}
  , severed(element_labels.piece, scene.supports.drop_loose_pieces())
{
  rebuild();
}



template <int dim>
CutBody<dim>::CutBody(const Scene<dim> &scene, const MPI_Comm communicator)
  : CutBody(scene,
            refine_near_cuts(scene.body,
                             scene.cut,
                             scene.body_parameters.refinement,
                             communicator),
            communicator)
{
}



template <int dim>
void
CutBody<dim>::rebuild()
{
  selection.forget();
  cells_at_seam.reset();
  present_model =
    std::make_unique<ElasticModel<dim>>(present_mesh,
                                        the_refinement,
                                        the_scene.body,
                                        the_scene.supports,
                                        the_scene.loads,
                                        materials,
                                        mpi_communicator,
                                        the_scene.body_parameters.element_type);
  present_model->set_load_factor(load_factor);
  if (the_scene.board.is_given)
    present_board =
      std::make_unique<BoardContacts<dim>>(*present_model,
                                           the_scene.board,
                                           materials.smallest_youngs_modulus(),
                                           present_mesh.extent());
  severed.remove_loads(*present_model);
}



template <int dim>
bool
CutBody<dim>::begin_cut(const Cut<dim> &cut)
{
  CutSurface<dim> surface = joined_faces(present_mesh, cut.surface.faces);
  for (const auto &piece : severed.floating())
    {
      const auto is_of_piece = [&](const CutFace<dim> &face) {
        return element_labels.piece[face.minus.first] == piece.piece;
      };
      if (!severed.drops &&
          std::any_of(surface.begin(), surface.end(), is_of_piece))
        throw FloatingPieceError(
          "The next cut goes through piece " + std::to_string(piece.piece) +
          ", which has no support to press it against. Hold it in subsection "
          "Support, cut it first, or set Support/Loose pieces = drop.");
      surface.erase(std::remove_if(surface.begin(), surface.end(), is_of_piece),
                    surface.end());
    }
  if (surface.empty())
    return false;
  selection.forget();
  if (newest_seam)
    finished_pairs.push_back(newest_seam->pairs());
  split_mesh_to_come = split_mesh(present_mesh, surface);
  begun_cuts.push_back({&cut, surface});
  areas.clear();
  present_entry_hats.clear();
  n_split_rows = 0;
  is_finished  = false;
  cells_at_seam.reset();
  const auto nodes = collect_surface_nodes(
    *present_model, {surface}, the_scene.body, split_mesh_to_come);
  newest_seam =
    std::make_unique<Seam<dim>>(nodes[0].pairs, find_rows(nodes[0]));
  return true;
}



template <int dim>
std::vector<Row>
CutBody<dim>::find_rows(const SurfaceNodes<dim> &nodes)
{
  n_cells_on_line = nodes.n_cells_on_line;
  std::vector<SurfaceStrip> of_bands;
  if (the_scene.division.release == DivisionParameters::Release::face_band)
    of_bands = strips();
  return make_rows(nodes, cut().edge, the_scene.division, of_bands);
}



template <int dim>
std::vector<SurfaceStrip>
CutBody<dim>::strips() const
{
  return strips_of_surface(
    the_scene.body, surface(), cut().edge, n_cells_on_line);
}



namespace
{
/** Whether two lists of pairs are of the same nodes in the same order. It is
 * not known of nodes that are in several pairs, where an earlier cut ends. */
template <int dim>
bool
are_same_nodes(const std::vector<NodePair<dim>> &a,
               const std::vector<NodePair<dim>> &b)
{
  const auto have_one_name = [](const NodePair<dim> &one,
                                const NodePair<dim> &other) {
    return one.name == other.name;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), have_one_name) &&
         std::adjacent_find(a.begin(), a.end(), have_one_name) == a.end();
}
} // namespace


template <int dim>
std::unique_ptr<ElasticModel<dim>>
CutBody<dim>::make_surgery()
{
  auto uncut          = std::move(present_model);
  present_mesh        = std::move(split_mesh_to_come);
  element_labels.side = find_sides(present_mesh, begun_cuts.back().surface);
  rebuild();
  present_model->internal.set(uncut->internal.by_cell());
  // The unknowns have new numbers, on earlier cuts too.
  std::vector<CutSurface<dim>> surfaces;
  for (const auto &begun : begun_cuts)
    surfaces.push_back(begun.surface);
  const auto nodes = collect_surface_nodes(
    *present_model, surfaces, the_scene.body, present_mesh);
  for (unsigned int c = 0; c < finished_pairs.size(); ++c)
    finished_pairs[c] = nodes[c].pairs;
  newest_seam = std::make_unique<Seam<dim>>(
    nodes.back().pairs,
    are_same_nodes(newest_seam->pairs(), nodes.back().pairs)
      ? newest_seam->rows()
      : find_rows(nodes.back()));
  severed.set_mesh(present_mesh,
                   find_pieces(present_mesh, element_labels.piece),
                   the_scene.supports,
                   the_scene.board.faces);
  present_entry_hats = find_entry_hats();
  return uncut;
}



template <int dim>
void
CutBody<dim>::split_nodes()
{
  make_surgery();
}



template <int dim>
LA::Vector
CutBody<dim>::split_nodes(const LA::Vector &displacement)
{
  const auto uncut = make_surgery();
  return transfer(uncut->discretization,
                  uncut->discretization.with_ghosts(displacement),
                  present_model->discretization);
}



template <int dim>
void
CutBody<dim>::release_row(const unsigned int row)
{
  n_split_rows = row + 1;
  update_parts();
}



template <int dim>
bool
CutBody<dim>::is_left_out(const unsigned int row) const
{
  return newest_seam->rows()[row].front.empty();
}



template <int dim>
void
CutBody<dim>::finish_cut()
{
  is_finished          = true;
  element_labels.piece = severed.parts();
  update_parts();
}



template <int dim>
void
CutBody<dim>::update_parts()
{
  const bool changed = severed.update([this] { return pair_states(); },
                                      cut().edge.direction,
                                      *newest_seam,
                                      *present_model);
  if (changed)
    selection.forget();
}



template <int dim>
PairState
CutBody<dim>::split_state() const
{
  using SplitRows = DivisionParameters::SplitRows;
  return the_scene.division.split_rows == SplitRows::opened &&
             !the_scene.blade.travels
           ? PairState::opened
           : PairState::free;
}



template <int dim>
PairStates
CutBody<dim>::pair_states() const
{
  if (is_finished)
    return PairStates(newest_seam->pairs().size(), PairState::free);
  return newest_seam->states_after(n_split_rows, split_state());
}



template <int dim>
std::vector<CutWall<dim>>
CutBody<dim>::walls() const
{
  std::vector<CutWall<dim>> all;
  for (const auto &pairs : finished_pairs)
    all.push_back({pairs, PairStates(pairs.size(), PairState::free)});
  if (newest_seam)
    all.push_back({newest_seam->pairs(), pair_states()});
  return all;
}



template <int dim>
std::vector<CutFaces<dim>>
CutBody<dim>::earlier_cuts() const
{
  std::vector<CutFaces<dim>> cuts;
  for (unsigned int c = 0; c < finished_pairs.size(); ++c)
    cuts.push_back({begun_cuts[c].surface, finished_pairs[c]});
  return cuts;
}



template <int dim>
BladeLoad<dim>
CutBody<dim>::blade_on_row(const unsigned int row) const
{
  return Setsudan::blade_on_row(
    *present_model, *newest_seam, row, cut().edge.direction, cut().edge_loads);
}



template <int dim>
const SeamCells<dim> &
CutBody<dim>::seam_cells() const
{
  if (!cells_at_seam)
    cells_at_seam =
      std::make_unique<SeamCells<dim>>(*present_model, *newest_seam);
  return *cells_at_seam;
}



template <int dim>
unsigned int
CutBody<dim>::n_pieces() const
{
  const auto &pieces = element_labels.piece;
  return *std::max_element(pieces.begin(), pieces.end()) + 1;
}



template <int dim>
std::vector<unsigned int>
CutBody<dim>::pieces_of_row(const unsigned int row) const
{
  std::set<unsigned int> pieces;
  for (const unsigned int pair : newest_seam->rows()[row].front)
    pieces.insert(element_labels.piece[newest_seam->pairs()[pair].element]);
  return {pieces.begin(), pieces.end()};
}



template <int dim>
const RowArea &
CutBody<dim>::area_of_row(const unsigned int row)
{
  if (areas.empty())
    areas = row_areas(
      strips(), the_scene.body, surface(), materials, newest_seam->rows());
  return areas[row];
}



template <int dim>
double
CutBody<dim>::length_of_rows(const unsigned int row, const unsigned int n) const
{
  const auto &rows = newest_seam->rows();
  if (row + n < rows.size())
    return rows[row + n].depth - rows[row].depth;
  const auto [entry, end] = travels_of_pairs(newest_seam->pairs(), cut().edge);
  return end - entry - rows[row].depth;
}



template <int dim>
BladeAdvance
CutBody<dim>::advance_of_blade(const unsigned int row) const
{
  const auto &rows  = newest_seam->rows();
  unsigned int next = row + 1;
  while (next < rows.size() && is_left_out(next))
    ++next;
  const bool is_last = next == rows.size();
  BladeAdvance advance{is_last ? no_blade(*present_model).nodal_forces
                               : blade_on_row(next).nodal_forces,
                       cut().edge_loads.sum() *
                         length_of_rows(row, next - row)};
  advance.change -= blade_on_row(row).nodal_forces;
  return advance;
}



template class CutBody<2>;
template class CutBody<3>;
} // namespace Setsudan
