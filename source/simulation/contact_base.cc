// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/contact_base.h>

#include <algorithm>
#include <map>

namespace Setsudan
{
using namespace dealii;

template <int dim>
double
shortest_row(const CutBody<dim> &body)
{
  double shortest = body.mesh().extent();
  if (!body.has_cut())
    return shortest;
  const auto &rows = body.seam().rows();
  for (unsigned int row = 1; row < rows.size(); ++row)
    shortest = std::min(shortest, rows[row].depth - rows[row - 1].depth);
  return shortest;
}



namespace
{
/** A parameter of a path that is small: of the travel, beside a row; of the
 * load factor, beside the scene's loads. */
template <int dim>
double
small_step(const CutBody<dim> &body)
{
  return 1e-9 * (body.scene().blade.travels
                   ? shortest_row(body)
                   : std::max(1., body.scene().division.max_load_factor));
}
} // namespace


template <int dim>
unsigned int
ContactBase<dim>::n_rows() const
{
  return body.has_cut() ? body.seam().rows().size() : 0;
}



template <int dim>
bool
ContactBase<dim>::has_forces() const
{
  return body.has_cut() && !body.scene().blade.travels;
}



template <int dim>
ContactBasis<dim>
ContactBase<dim>::make_basis(CutBody<dim> &body, const BladeProfile &profile)
{
  if (!body.has_cut())
    return {body.communicator(), *body.board()};
  return {body.model(),
          body.surface(),
          body.seam(),
          body.cut().edge,
          {body.scene().blade.sliding,
           !profile.facets.empty(),
           body.scene().blade.travels,
           !body.model().is_linear()},
          body.earlier_cuts(),
          body.board(),
          body.entry_hats()};
}



template <int dim>
ContactBase<dim>::ContactBase(CutBody<dim> &body,
                              const BladeProfile &profile,
                              const LA::Vector &displacement)
  : body(body)
  , profile(profile)
  , basis(make_basis(body, profile))
  , step(small_step(body))
{
  if (body.board())
    measured = work_of(basis.vectors(), displacement);
}



template <int dim>
std::unique_ptr<ContactPath<dim>>
ContactBase<dim>::make_path(const BladeProfile &of_blade,
                            const unsigned int n_split,
                            const unsigned int n_ahead,
                            const LAPACKFullMatrix<double> &products,
                            const UntouchedBody &untouched,
                            const BladeMotion &motion,
                            const ContactPath<dim> *neighbour) const
{
  auto path = std::make_unique<ContactPath<dim>>(
    std::make_unique<ContactStage<dim>>(
      basis, n_split, n_ahead, products, untouched),
    of_blade,
    body.scene().blade.sliding,
    step);
  path->begin(motion, neighbour, measured);
  return path;
}



template <int dim>
std::map<types::global_dof_index, double>
ContactBase<dim>::on_unknowns(const std::vector<double> &forces,
                              const unsigned int begin,
                              const unsigned int end) const
{
  std::map<types::global_dof_index, double> of_unknowns;
  for (unsigned int v = begin; v < end; ++v)
    if (forces[v] != 0)
      for (const auto &[unknown, factor] : basis.vectors()[v])
        of_unknowns[unknown] += factor * forces[v];
  return of_unknowns;
}



template <int dim>
LA::Vector
ContactBase<dim>::nodal_forces(
  const std::map<types::global_dof_index, double> &forces) const
{
  LA::Vector vector = body.model().discretization.zero_vector();
  for (const auto &[unknown, force] : forces)
    if (body.model().discretization.owned.is_element(unknown))
      vector(unknown) = force;
  vector.compress(VectorOperation::insert);
  return vector;
}



template <int dim>
void
ContactBase<dim>::add_outer_forces(std::vector<double> &of_vectors,
                                   BladeLoad<dim> &blade) const
{
  for (unsigned int h = 0; h < basis.hats().size(); ++h)
    {
      const auto &outer = basis.hats()[h].outer;
      if (!outer)
        continue;
      Tensor<1, dim> force;
      for (unsigned int v = basis.first_vector_of_hat(h);
           v < basis.first_vector_of_hat(h + 1);
           ++v)
        {
          // Components follow each other in all vectors.
          for (unsigned int i = 0; i < basis.vectors()[v].size(); ++i)
            force[i % dim] += basis.vectors()[v][i].second * of_vectors[v];
          of_vectors[v] = 0;
        }
      if (force.norm() > 0)
        blade.forces.push_back({outer->hat.center, force});
    }
}



template <int dim>
BladeLoad<dim>
ContactBase<dim>::blade_load(const ContactPath<dim> &path,
                             const unsigned int row,
                             const double travel) const
{
  BladeLoad<dim> blade = no_blade(body.model());
  if (!body.has_cut())
    return blade;
  // Behind the last row the blade stays with it.
  blade.row       = std::min<unsigned int>(row, body.seam().rows().size() - 1);
  auto of_vectors = path.forces(travel);
  blade.nodal_forces = nodal_forces(
    on_unknowns(of_vectors, 0, basis.vector_of_board_corner(0, 0)));
  add_outer_forces(of_vectors, blade);
  const auto forces =
    on_unknowns(of_vectors, 0, basis.vector_of_board_corner(0, 0));
  for (const auto &pair : body.seam().pairs())
    for (const auto *side : {&pair.minus, &pair.plus})
      {
        Tensor<1, dim> force;
        for (unsigned int c = 0; c < dim; ++c)
          if (const auto found = forces.find((*side)[c]); found != forces.end())
            force[c] = found->second;
        if (force.norm() > 0 && (side == &pair.minus || pair.is_double()))
          blade.forces.push_back({pair.position, force});
      }
  return blade;
}



template <int dim>
std::optional<BoardLoad<dim>>
ContactBase<dim>::board_load(const ContactPath<dim> &path,
                             const double travel) const
{
  if (!body.board())
    return {};
  const auto of_board = [&](const std::vector<double> &forces) {
    return nodal_forces(on_unknowns(
      forces, basis.vector_of_board_corner(0, 0), basis.vectors().size()));
  };
  const auto forces = path.forces(travel);
  BoardLoad<dim> load{of_board(forces),
                      of_board(path.foundation_forces(travel)),
                      {},
                      path.resultants().board(travel)};
  std::map<unsigned int, Tensor<1, dim>> of_piece;
  const auto &corners = body.board()->corners();
  for (unsigned int i = 0; i < corners.size(); ++i)
    {
      Tensor<1, dim> force;
      for (unsigned int d = 0; d < dim; ++d)
        force += forces[basis.vector_of_board_corner(i, d)] *
                 corners[i].hat.area * body.board()->directions()[d];
      if (force.norm() > 0)
        load.forces.push_back({corners[i].hat.center, force});
      of_piece[body.labels().piece[corners[i].hat.element]] += force;
    }
  const auto &normal = body.board()->directions()[0];
  for (const auto &[piece, force] : of_piece)
    {
      const double pressure = force * normal;
      const double friction = (force - pressure * normal).norm();
      const double part =
        friction > 0 ? friction / (body.board()->friction * pressure) : 0.;
      if (part > load.part_of_friction)
        {
          load.sliding_piece    = piece;
          load.part_of_friction = part;
        }
    }
  return load;
}



template <int dim>
void
ContactBase<dim>::measure_board(State<dim> &state) const
{
  if (state.board)
    state.board->passed =
      depth_beyond_board(body.model(), body.scene().board, state.displacement);
}



template double
shortest_row(const CutBody<2> &);
template double
shortest_row(const CutBody<3> &);
template class ContactBase<2>;
template class ContactBase<3>;
} // namespace Setsudan
