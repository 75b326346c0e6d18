#include <setsudan/cut/seam/floating_ties.h>
#include <setsudan/cut/seam/sides.h>
#include <setsudan/cut/surface/mesh_surgery.h>
#include <setsudan/cut/surface/near_cut.h>
#include <setsudan/mesh/pieces.h>
#include <setsudan/simulation/cut_body.h>
#include <setsudan/solver/condensed/condensed_solver.h>

#include <algorithm>
#include <set>

namespace Setsudan
{
using namespace dealii;

template <int dim>
CutBody<dim>::CutBody(const Scene<dim> &scene,
                      const Refinement &refinement,
                      const MPI_Comm communicator)
  : communicator(communicator)
  , refinement(refinement)
  , mesh(scene.body.mesh)
  , scene(scene)
  , choice(scene)
{
  rebuild();
  labels.side.assign(mesh.cells.size(), 0);
  labels.piece = find_pieces(mesh);
  parts        = labels.piece;
}



template <int dim>
CutBody<dim>::CutBody(const Scene<dim> &scene, const MPI_Comm communicator)
  : CutBody(scene,
            refine_near_cuts(scene.body,
                             scene.cut,
                             scene.shape.refinement,
                             communicator),
            communicator)
{
}



template <int dim>
void
CutBody<dim>::rebuild()
{
  choice.forget();
  cells_at_seam.reset();
  model = std::make_unique<ElasticModel<dim>>(mesh,
                                              refinement,
                                              scene.body,
                                              scene.supports,
                                              scene.loads,
                                              scene.material,
                                              communicator,
                                              scene.shape.element_type);
  if (scene.supports.drop_loose_pieces())
    for (const auto &loose : floating_pieces)
      remove_loads_from_piece(labels.piece, loose, *model);
}



template <int dim>
Seam<dim>
CutBody<dim>::make_seam(const BegunCut &begun,
                        const CoarseMesh<dim> &split) const
{
  const auto nodes =
    collect_surface_nodes(*model, begun.surface, scene.body, split);
  return Seam<dim>(nodes.pairs,
                   make_rows(nodes, begun.cut->edge, scene.division));
}



template <int dim>
bool
CutBody<dim>::approach(const Cut<dim> &cut)
{
  CutSurface<dim> surface = joined_faces(mesh, cut.surface.faces);
  for (const auto &loose : floating_pieces)
    {
      const auto is_loose = [&](const CutFace<dim> &face) {
        return labels.piece[face.minus.first] == loose.piece;
      };
      if (!scene.supports.drop_loose_pieces() &&
          std::any_of(surface.begin(), surface.end(), is_loose))
        throw std::runtime_error(
          "The next cut goes through piece " + std::to_string(loose.piece) +
          ", which has no support to press it against. Hold it in subsection "
          "Support, cut it first, or set Support/Loose pieces = drop.");
      surface.erase(std::remove_if(surface.begin(), surface.end(), is_loose),
                    surface.end());
    }
  if (surface.empty())
    return false;
  choice.forget();
  split = split_mesh(mesh, surface);
  begun_cuts.push_back({&cut, surface});
  areas.clear();
  n_split_rows = 0;
  cells_at_seam.reset();
  seams.push_back(make_seam(begun_cuts.back(), split));
  return true;
}



template <int dim>
void
CutBody<dim>::open()
{
  mesh        = std::move(split);
  labels.side = find_sides(mesh, begun_cuts.back().surface);
  rebuild();
  seams.clear();
  for (const auto &begun : begun_cuts)
    {
      seams.push_back(make_seam(begun, mesh));
      if (seams.size() < begun_cuts.size())
        seams.back().set_all_states(Seam<dim>::State::free);
    }
  parts   = find_pieces(mesh, labels.piece);
  motions = std::make_unique<PieceMotions<dim>>(mesh, parts, scene.supports);
}



template <int dim>
void
CutBody<dim>::release(const unsigned int row)
{
  seam().set_row_state(row, state_of_split_rows());
  n_split_rows = row + 1;
  find_loose_pieces();
}



template <int dim>
std::string
CutBody<dim>::why_anew() const
{
  return choice.why_anew(*model, seams.empty() ? nullptr : &seam());
}



template <int dim>
bool
CutBody<dim>::is_foreseen() const
{
  return why_anew().empty() && choice.is_foreseen(all_held());
}



template <int dim>
bool
CutBody<dim>::all_held() const
{
  return motions && motions->all_held();
}



template <int dim>
void
CutBody<dim>::expect_single_states()
{
  choice.expect_single_states();
}



template <int dim>
std::shared_ptr<TangentSolver>
CutBody<dim>::equilibrium_under(AffineConstraints<double> &&constraints)
{
  return choice.solver(*model,
                       seams.empty() ? nullptr : &seam(),
                       n_split_rows,
                       std::move(constraints),
                       all_held(),
                       other_states());
}



template <int dim>
typename EquilibriumChoice<dim>::OtherStates
CutBody<dim>::other_states()
{
  return {[this] { return constraints_of(seams.size() - 1); },
          [this](const auto &visit) { for_each_row_to_come(visit); }};
}



template <int dim>
void
CutBody<dim>::for_each_row_to_come(
  const std::function<void(const AffineConstraints<double> &)> &visit)
{
  visit(constraints());
  const Seam<dim> present = seam();
  for (unsigned int row = 0; row < seam().rows().size(); ++row)
    {
      seam().set_row_state(row, state_of_split_rows());
      visit(constraints());
    }
  seam() = present;
}



template <int dim>
typename Seam<dim>::State
CutBody<dim>::state_of_split_rows() const
{
  return scene.division.opens ? Seam<dim>::State::opened
                              : Seam<dim>::State::free;
}



template <int dim>
std::shared_ptr<TangentSolver>
CutBody<dim>::equilibrium()
{
  return equilibrium_under(constraints());
}



template <int dim>
std::shared_ptr<TangentSolver>
CutBody<dim>::equilibrium_without(const unsigned int row)
{
  // A free pair stays free, so that the row cannot be tied again.
  const Seam<dim> present = seam();
  seam().set_row_state(row, Seam<dim>::State::free);
  std::size_t n_loose = 0;
  if (!all_held())
    for (const auto &group : motions->find_floating(seam().links(parts)))
      n_loose += group.loose.size();
  auto without = constraints();
  seam()       = present;
  if (n_loose > floating_pieces.size())
    throw std::runtime_error(
      "Splitting row " + std::to_string(row + 1) +
      " leaves a part that nothing holds, and there is no telling what energy "
      "that releases. Hold it in subsection Support, or choose another "
      "Yield/Criterion.");
  return equilibrium_under(std::move(without));
}



template <int dim>
bool
CutBody<dim>::is_left_out(const unsigned int row) const
{
  return seam().rows()[row].front.empty();
}



template <int dim>
void
CutBody<dim>::divide()
{
  seam().set_all_states(Seam<dim>::State::free);
  labels.piece = parts;
  find_loose_pieces();
}



template <int dim>
void
CutBody<dim>::find_loose_pieces()
{
  const auto known    = floating_pieces;
  const auto is_known = [&](const FloatingPiece &piece) {
    return std::find(known.begin(), known.end(), piece) != known.end();
  };
  const bool drops = scene.supports.drop_loose_pieces();
  bool more        = !all_held();
  while (more)
    {
      const std::size_t n_before = floating_pieces.size();
      floating_pieces.clear();
      for (const auto &group : motions->find_floating(seam().links(parts)))
        {
          const auto &loose = group.loose;
          floating_pieces.insert(
            floating_pieces.end(), loose.begin(), loose.end());
          if (drops || std::all_of(loose.begin(), loose.end(), is_known))
            continue;
          check_loads_on_loose_group(*model, parts, group);
          check_ties_of_loose_group(seam(), parts, group, cut().edge.direction);
        }
      // A piece that is left out holds no others, which may be loose now.
      more = drops && floating_pieces.size() > n_before;
      if (more)
        drop(floating_pieces);
    }
  if (floating_pieces != known)
    choice.forget();
}



template <int dim>
void
CutBody<dim>::drop(const std::vector<FloatingPiece> &loose)
{
  std::set<unsigned int> numbers;
  for (const auto &piece : loose)
    {
      numbers.insert(piece.piece);
      remove_loads_from_piece(parts, piece, *model);
    }
  seam().leave_out(parts, numbers);
}



template <int dim>
const Cut<dim> &
CutBody<dim>::cut() const
{
  return *begun_cuts.back().cut;
}



template <int dim>
Seam<dim> &
CutBody<dim>::seam()
{
  return seams.back();
}



template <int dim>
const Seam<dim> &
CutBody<dim>::seam() const
{
  return seams.back();
}



template <int dim>
const SeamCells<dim> &
CutBody<dim>::seam_cells() const
{
  if (!cells_at_seam)
    cells_at_seam = std::make_unique<SeamCells<dim>>(*model, seam());
  return *cells_at_seam;
}



template <int dim>
AffineConstraints<double>
CutBody<dim>::constraints_of(const unsigned int n_seams) const
{
  const auto &discretization = model->discretization;
  IndexSet lines             = discretization.relevant;
  for (const auto &seam : seams)
    lines.add_indices(
      seam.coupled_indices(discretization.dof_handler.n_dofs()));
  AffineConstraints<double> constraints(lines);
  for (const auto *part : {&model->hanging, &model->supports})
    constraints.merge(
      *part, AffineConstraints<double>::no_conflicts_allowed, true);
  if (scene.supports.drop_loose_pieces())
    for (const auto &loose : floating_pieces)
      constrain_dropped_piece(discretization, parts, loose, constraints);
  else if (!floating_pieces.empty())
    for (const auto index :
         unknowns_of_hold(discretization, mesh, parts, floating_pieces))
      if (constraints.can_store_line(index))
        constraints.add_line(index);
  for (unsigned int s = 0; s < n_seams; ++s)
    seams[s].add_constraints(constraints);
  constraints.close();
  return constraints;
}



template <int dim>
AffineConstraints<double>
CutBody<dim>::constraints() const
{
  return constraints_of(seams.size());
}



template <int dim>
unsigned int
CutBody<dim>::n_pieces() const
{
  return *std::max_element(labels.piece.begin(), labels.piece.end()) + 1;
}



template <int dim>
std::vector<unsigned int>
CutBody<dim>::pieces_of_row(const unsigned int row) const
{
  std::set<unsigned int> pieces;
  for (const unsigned int pair : seam().rows()[row].front)
    pieces.insert(labels.piece[seam().pairs()[pair].element]);
  return {pieces.begin(), pieces.end()};
}



template <int dim>
const RowArea &
CutBody<dim>::area_of_row(const unsigned int row)
{
  if (areas.empty())
    areas = row_areas(scene.body,
                      scene.material,
                      begun_cuts.back().surface,
                      cut().edge,
                      seam().rows());
  return areas[row];
}



template <int dim>
LA::Vector
CutBody<dim>::internal_forces(const LA::Vector &displacement)
{
  return Setsudan::internal_forces(*model, displacement);
}



template class CutBody<2>;
template class CutBody<3>;
} // namespace Setsudan
