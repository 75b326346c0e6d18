// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/contact_path.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

template <int dim>
Quadratic
ContactPath<dim>::energy() const
{
  if (energy_of_piece)
    return *energy_of_piece;
  Quadratic result = stage->untouched.energy;
  const auto add   = [&](const Condition &condition,
                       const double constant,
                       const double slope) {
    for (const auto &[a, factor] : condition.exerted)
      {
        const double u0 =
          factor * (piece.displacements.constant[a] + moved_by_adhesion[a]) / 2;
        const double u1 = factor * piece.displacements.slope[a] / 2;
        result.c[0] += constant * u0;
        result.c[1] += constant * u1 + slope * u0;
        result.c[2] += slope * u1;
      }
  };
  const auto &[constant, slope] = piece.multipliers;
  for (unsigned int i = 0; i < conditions.size(); ++i)
    if (piece.active[i])
      add(conditions[i], constant[i], slope[i]);
  for (const auto &[condition, strength] : adhesions)
    add(condition, strength, 0);
  add_foundation_energy(result);
  energy_of_piece = result;
  return result;
}



template <int dim>
void
ContactPath<dim>::add_foundation_energy(Quadratic &energy) const
{
  const auto &[constant, slope] = piece.springs;
  for (unsigned int i = 0; i < constant.size(); ++i)
    if (const double stiffness = conditions[i].spring; stiffness > 0)
      {
        for (const auto &[a, factor] : conditions[i].measured)
          {
            const double u0 =
              factor *
              (piece.displacements.constant[a] + moved_by_adhesion[a]) / 2;
            const double u1 = factor * piece.displacements.slope[a] / 2;
            energy.c[0] += constant[i] * u0;
            energy.c[1] += constant[i] * u1 + slope[i] * u0;
            energy.c[2] += slope[i] * u1;
          }
        energy.c[0] -= constant[i] * constant[i] / (2 * stiffness);
        energy.c[1] -= constant[i] * slope[i] / stiffness;
        energy.c[2] -= slope[i] * slope[i] / (2 * stiffness);
      }
}



template <int dim>
ContactResultants
ContactPath<dim>::resultants() const
{
  ContactResultants result;
  const auto add =
    [&](const Condition &condition, const double constant, const double slope) {
      const auto to = [&](Quadratic &sum, const double factor) {
        sum.c[0] += constant * factor;
        sum.c[1] += slope * factor;
      };
      if (condition.kind == Kind::edge)
        to(result.edge, condition.force);
      if (condition.kind == Kind::edge || condition.kind == Kind::flank)
        to(result.aside, condition.aside);
      if (condition.kind == Kind::walls)
        to(result.walls, condition.force);
      if (condition.kind == Kind::board)
        to(result.board, condition.force);
      if (!condition.is_of_flank())
        return;
      to(result.flanks, condition.force);
      to(result.friction, condition.friction);
      to(result.unfelt, condition.unfelt);
    };
  const auto &[constant, slope] = piece.multipliers;
  for (unsigned int i = 0; i < conditions.size(); ++i)
    if (piece.active[i])
      add(conditions[i], constant[i], slope[i]);
  for (const auto &[condition, strength] : adhesions)
    add(condition, strength, 0);
  return result;
}



template <int dim>
Quadratic
ContactPath<dim>::energy_set_free(const ContactPath &after) const
{
  Quadratic result      = energy();
  const Quadratic rest  = after.energy();
  const Quadratic taken = friction_work_to(after);
  for (unsigned int i = 0; i < 3; ++i)
    result.c[i] -= rest.c[i] + taken.c[i];
  return result;
}



template <int dim>
double
ContactPath<dim>::contact_area() const
{
  double area = 0;
  for (unsigned int i = 0; i < conditions.size(); ++i)
    if (piece.active[i] && conditions[i].kind == Kind::flank)
      area += basis.hats()[conditions[i].place].area;
  return area;
}



template <int dim>
std::vector<double>
ContactPath<dim>::forces_on_vectors(
  const std::function<double(unsigned int)> &force,
  const VectorSum Condition::*along) const
{
  std::vector<double> result(basis.vectors().size(), 0.);
  for (unsigned int i = 0; i < conditions.size(); ++i)
    for (const auto &[place, factor] : conditions[i].*along)
      result[stage->vector_at[place]] += factor * force(i);
  return result;
}



template <int dim>
std::vector<double>
ContactPath<dim>::forces(const double travel) const
{
  auto result = forces_on_vectors(
    [&](const unsigned int i) { return piece.multipliers(i, travel); },
    &Condition::exerted);
  for (const auto &[condition, strength] : adhesions)
    for (const auto &[place, factor] : condition.exerted)
      result[stage->vector_at[place]] += factor * strength;
  return result;
}



template <int dim>
std::vector<double>
ContactPath<dim>::foundation_forces(const double travel) const
{
  return forces_on_vectors(
    [&](const unsigned int i) {
      return piece.springs.constant.size() == 0 ? 0. : piece.springs(i, travel);
    },
    &Condition::measured);
}



template <int dim>
std::array<double, 2>
ContactPath<dim>::violation(const std::vector<double> &measured,
                            const double travel) const
{
  double missing = 0, pull = 0, push = 0;
  for (unsigned int i = 0; i < conditions.size(); ++i)
    {
      const Condition &condition = conditions[i];
      if (condition.kind != Kind::walls)
        continue;
      double gap = -condition.constant;
      for (const auto &[place, factor] : condition.measured)
        gap += factor * measured[stage->vector_at[place]];
      missing = std::max(missing, -gap / condition.area);
      pull    = std::max(pull, -piece.multipliers(i, travel));
      push    = std::max(push, piece.multipliers(i, travel));
    }
  return {{missing, pull > 0 ? pull / (pull + push) : 0.}};
}



template <int dim>
bool
ContactPath<dim>::is_stable(const unsigned int n_negative) const
{
  // Those that hold, and springs that the body does not have.
  std::vector<unsigned int> present;
  unsigned int n_springs = 0;
  for (unsigned int i = 0; i < conditions.size(); ++i)
    if (piece.active[i] || conditions[i].spring > 0)
      {
        present.push_back(i);
        n_springs += piece.active[i] ? 0 : 1;
      }
  if (present.empty())
    return n_negative == 0;
  LAPACKFullMatrix<double> block(present.size());
  double largest = 0;
  for (unsigned int i = 0; i < present.size(); ++i)
    for (unsigned int j = 0; j < present.size(); ++j)
      {
        const Condition &other = conditions[present[j]];
        for (const auto &[a, measured] : conditions[present[i]].measured)
          for (const auto &[b, exerted] :
               piece.active[present[j]] ? other.exerted : other.measured)
            {
              const double product =
                measured * exerted * stage->products(a, b) / 2;
              block(i, j) += product;
              block(j, i) += product;
              largest = std::max(largest, std::abs(block(i, j)));
            }
      }
  for (unsigned int i = 0; i < present.size(); ++i)
    if (!piece.active[present[i]])
      {
        const double length = 1 / conditions[present[i]].spring;
        block(i, i) -= length;
        largest = std::max(largest, length);
      }
  // Some conditions may follow from others.
  constexpr double round_off = 1e-10;
  Vector<double> eigenvalues;
  FullMatrix<double> eigenvectors;
  block.compute_eigenvalues_symmetric(-2 * largest * present.size(),
                                      -round_off * largest,
                                      0.,
                                      eigenvalues,
                                      eigenvectors);
  return eigenvalues.size() == n_negative + n_springs;
}



template <int dim>
double
ContactPath<dim>::work_to_fulfil(const std::vector<double> &measured,
                                 const double travel) const
{
  double work = 0;
  for (unsigned int i = 0; i < conditions.size(); ++i)
    {
      const Condition &condition = conditions[i];
      const double multiplier    = piece.multipliers(i, travel);
      const bool has_sign        = condition.kind != Kind::hold;
      if (!piece.active[i] || (has_sign && multiplier <= 0))
        continue;
      double missing = condition.constant + condition.per_travel * travel;
      for (const auto &[place, factor] : condition.measured)
        missing -= factor * measured[stage->vector_at[place]];
      if (!sliding.is_guided && condition.is_of_flank())
        missing -= condition.across * shift(travel);
      work += has_sign ? multiplier * std::max(missing, 0.)
                       : std::abs(multiplier * missing);
    }
  return work;
}



#define INSTANTIATE(dim)                                                     \
  template Quadratic ContactPath<dim>::energy() const;                       \
  template ContactResultants ContactPath<dim>::resultants() const;           \
  template Quadratic ContactPath<dim>::energy_set_free(const ContactPath &)  \
    const;                                                                   \
  template double ContactPath<dim>::contact_area() const;                    \
  template std::vector<double> ContactPath<dim>::forces(const double) const; \
  template std::vector<double> ContactPath<dim>::foundation_forces(          \
    const double) const;                                                     \
  template bool ContactPath<dim>::is_stable(const unsigned int) const;       \
  template double ContactPath<dim>::work_to_fulfil(                          \
    const std::vector<double> &, const double) const;                        \
  template std::array<double, 2> ContactPath<dim>::violation(                \
    const std::vector<double> &, const double) const;

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
