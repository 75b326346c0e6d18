#include <setsudan/cut/mesh_surgery.h>
#include <setsudan/cut/sides.h>
#include <setsudan/simulation/cut_body.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

template <int dim>
CutBody<dim>::CutBody(const Scene<dim> &scene, const MPI_Comm communicator)
  : communicator(communicator)
  , mesh(scene.body.mesh)
  , scene(scene)
{
  rebuild();
  labels.side.assign(mesh.cells.size(), 0);
  labels.piece = find_pieces(mesh);
}



template <int dim>
void
CutBody<dim>::rebuild()
{
  model = std::make_unique<ElasticModel<dim>>(
    mesh,
    scene.body,
    scene.supports,
    scene.loads,
    Hooke(scene.material.youngs_modulus, scene.material.poissons_ratio),
    communicator);
}



template <int dim>
Seam<dim>
CutBody<dim>::make_seam(const CutSurface<dim> &surface) const
{
  const auto pairs = collect_node_pairs(*model, surface, scene.body);
  const BladeEdge<dim> edge(surface.front().normal, scene.blade.direction);
  return Seam<dim>(
    pairs,
    make_rows(pairs, scene.blade.direction, edge, scene.division.release));
}



template <int dim>
void
CutBody<dim>::approach(const CutSurface<dim> &surface)
{
  for (const auto &loose : loose_pieces)
    for (const auto &face : surface)
      if (labels.piece[face.minus.first] == loose.piece ||
          labels.piece[face.plus.first] == loose.piece)
        throw std::runtime_error(
          "The next cut goes through piece " + std::to_string(loose.piece) +
          ", which has no support to press it against. Support it with "
          "Support/Fixed faces or Fixed nodes, or cut it first.");
  surfaces.push_back(surface);
  seams.push_back(make_seam(surface));
}



template <int dim>
void
CutBody<dim>::open()
{
  mesh        = split_mesh(mesh, surfaces.back());
  labels.side = find_sides(mesh, surfaces.back());
  rebuild();
  seams.clear();
  for (const auto &surface : surfaces)
    {
      seams.push_back(make_seam(surface));
      if (seams.size() < surfaces.size())
        seams.back().set_all_states(Seam<dim>::State::free);
    }
}



template <int dim>
void
CutBody<dim>::divide()
{
  seam().set_all_states(Seam<dim>::State::free);
  labels.piece = find_pieces(mesh);
  loose_pieces = find_loose_pieces(mesh, labels.piece, scene.supports);
  for (const auto &loose : loose_pieces)
    check_loads_on_loose_piece(*model, labels.piece, loose);
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
AffineConstraints<double>
CutBody<dim>::constraints() const
{
  const auto &discretization = model->discretization;
  IndexSet lines             = discretization.relevant;
  for (const auto &seam : seams)
    lines.add_indices(
      seam.coupled_indices(discretization.dof_handler.n_dofs()));
  AffineConstraints<double> constraints(lines);
  constraints.merge(
    model->supports, AffineConstraints<double>::no_conflicts_allowed, true);
  for (const auto &seam : seams)
    seam.add_constraints(constraints);
  for (const auto &loose : loose_pieces)
    constrain_loose_piece(discretization, mesh, loose, constraints);
  constraints.close();
  return constraints;
}



template <int dim>
unsigned int
CutBody<dim>::n_pieces() const
{
  return *std::max_element(labels.piece.begin(), labels.piece.end()) + 1;
}



template class CutBody<2>;
template class CutBody<3>;
} // namespace Setsudan
