// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/seam/severed_parts.h>
#include <setsudan/parameters/exceptions.h>

#include <algorithm>
#include <set>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Refuse to go on where a pair is still tied against which the blade would
 * press a floating group that nothing holds. */
template <int dim>
void
check_ties(const Seam<dim> &seam,
           const PairStates &states,
           const std::vector<unsigned int> &parts,
           const FloatingGroup<dim> &group,
           const Tensor<1, dim> &direction)
{
  for (unsigned int p = 0; p < seam.pairs().size(); ++p)
    {
      const auto &pair = seam.pairs()[p];
      const auto body  = std::find(
        group.pieces.begin(), group.pieces.end(), parts[pair.element]);
      if (!pair.is_double() || states[p] != PairState::tied ||
          body == group.pieces.end())
        continue;
      auto form = group.held.zero();
      group.held.add_displacement(
        body - group.pieces.begin(), pair.position, direction, form);
      if (group.held.unconstrained_part(form).l2_norm() > 1e-6)
        throw FloatingPieceError(
          "The cut goes on through piece " + std::to_string(*body) +
          ", which it has severed and which has no support to press it "
          "against. Hold it in subsection Support, or set Support/Loose pieces "
          "= drop.");
    }
}
} // namespace


template <int dim>
SeveredParts<dim>::SeveredParts(const std::vector<unsigned int> &parts,
                                const bool drops)
  : drops(drops)
  , part_of_element(parts)
{
}



template <int dim>
void
SeveredParts<dim>::set_mesh(const CoarseMesh<dim> &mesh,
                            const std::vector<unsigned int> &parts,
                            const Supports<dim> &supports,
                            const std::vector<CellFace> &on_board)
{
  part_of_element = parts;
  motions =
    std::make_unique<PieceMotions<dim>>(mesh, parts, supports, on_board);
}



template <int dim>
const std::vector<unsigned int> &
SeveredParts<dim>::parts() const
{
  return part_of_element;
}



template <int dim>
bool
SeveredParts<dim>::all_held() const
{
  return motions && motions->all_held();
}



template <int dim>
const std::vector<FloatingPiece> &
SeveredParts<dim>::floating() const
{
  return floating_parts;
}



template <int dim>
std::size_t
SeveredParts<dim>::n_floating(const Seam<dim> &seam,
                              const PairStates &states) const
{
  std::size_t n = 0;
  if (!all_held())
    for (const auto &group :
         motions->find_floating(seam.links(states, part_of_element)))
      n += group.loose.size();
  return n;
}



template <int dim>
bool
SeveredParts<dim>::update(const std::function<PairStates()> &states,
                          const Tensor<1, dim> &direction,
                          Seam<dim> &seam,
                          ElasticModel<dim> &model)
{
  const auto known    = floating_parts;
  const auto is_known = [&](const FloatingPiece &piece) {
    return std::find(known.begin(), known.end(), piece) != known.end();
  };
  bool more = !all_held();
  while (more)
    {
      const std::size_t n_before = floating_parts.size();
      floating_parts.clear();
      for (const auto &group :
           motions->find_floating(seam.links(states(), part_of_element)))
        {
          const auto &loose = group.loose;
          floating_parts.insert(
            floating_parts.end(), loose.begin(), loose.end());
          if (drops || std::all_of(loose.begin(), loose.end(), is_known))
            continue;
          check_loads_on_loose_group(model, part_of_element, group);
          check_ties(seam, states(), part_of_element, group, direction);
        }
      // A part that is left out holds no others, which may float now.
      more = drops && floating_parts.size() > n_before;
      if (!more)
        continue;
      std::set<unsigned int> numbers;
      for (const auto &piece : floating_parts)
        numbers.insert(piece.piece);
      seam.leave_out(part_of_element, numbers);
      remove_loads(model);
    }
  return floating_parts != known;
}



template <int dim>
void
SeveredParts<dim>::remove_loads(ElasticModel<dim> &model) const
{
  if (drops)
    for (const auto &piece : floating_parts)
      remove_loads_from_piece(part_of_element, piece, model);
}



template <int dim>
void
SeveredParts<dim>::add_constraints(const Discretization<dim> &discretization,
                                   const CoarseMesh<dim> &mesh,
                                   AffineConstraints<double> &constraints) const
{
  if (drops)
    for (const auto &piece : floating_parts)
      constrain_dropped_piece(
        discretization, part_of_element, piece, constraints);
  else if (!floating_parts.empty())
    for (const auto index : unknowns_of_hold(
           discretization, mesh, part_of_element, floating_parts))
      if (constraints.can_store_line(index))
        constraints.add_line(index);
}



template class SeveredParts<2>;
template class SeveredParts<3>;
} // namespace Setsudan
