// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/hyperelastic_law.h>
#include <setsudan/mechanics/cell_batches.h>

// What batches of neo-Hookean cells do under finite strain.

namespace Setsudan
{
using namespace dealii;

template <int dim>
void
CellBatches<dim>::find_forms()
{
  const auto form_of = [&](const Cell &cell) -> std::optional<NeoHookeForm> {
    const Material &material =
      materials.of_element(discretization.element(cell));
    const auto *const law = material.law->hyperelastic();
    if (law == nullptr || material.is_mixed)
      return {};
    return law->neo_hooke();
  };
  std::vector<NeoHookeForm> found;
  for (unsigned int batch = 0, first = 0; batch < size();
       first += n_cells_of_batch[batch++])
    for (unsigned int lane = 0; lane < n_cells_of_batch[batch]; ++lane)
      {
        const auto form = form_of(all_cells[first + lane]);
        if (!form)
          return;
        if (lane == 0)
          found.push_back(*form);
        // The volumetric energy is that of all materials.
        else if (form->is_isochoric != found.back().is_isochoric)
          return;
      }
  forms = found;
}



template <int dim>
bool
CellBatches<dim>::is_neo_hookean() const
{
  return forms.has_value();
}



template <int dim>
double
CellBatches<dim>::add_neo_hooke(const Vector &displacement, Vector &forces)
{
  const auto add_batch        = discretization.type == ElementType::serendipity
                                  ? kernel.serendipity_neo_hooke
                                  : kernel.quadratic_neo_hooke;
  const double *const at_rest = positions().begin();
  std::vector<double> energies(kernel.n_lanes);
  double energy = 0;
  for (unsigned int batch = 0; batch < size(); ++batch)
    {
      add_batch((*this)[batch],
                {(*forms)[batch], at_rest, displacement.begin()},
                forces.begin(),
                energies.data());
      for (unsigned int lane = 0; lane < n_cells_of_batch[batch]; ++lane)
        energy += energies[lane];
    }
  return energy;
}



template <int dim>
std::shared_ptr<const typename CellBatches<dim>::Tangent>
CellBatches<dim>::tangent(const Vector &displacement,
                          const Vector *const before)
{
  const auto of_batch         = discretization.type == ElementType::serendipity
                                  ? kernel.serendipity_tangent
                                  : kernel.quadratic_tangent;
  const double *const at_rest = positions().begin();
  const unsigned int n_of_batch =
    Utilities::pow(discretization.n_gauss_points(), dim) * n_in_tangent<dim> *
    kernel.n_lanes;
  const auto result = std::make_shared<Tangent>();
  result->resize_fast(std::size_t(size()) * n_of_batch);
  for (unsigned int batch = 0; batch < size(); ++batch)
    of_batch((*this)[batch],
             {(*forms)[batch], at_rest, displacement.begin()},
             before != nullptr ? before->begin() : nullptr,
             result->data() + std::size_t(batch) * n_of_batch);
  return result;
}



#define INSTANTIATE(dim)                                                     \
  template void CellBatches<dim>::find_forms();                              \
  template bool CellBatches<dim>::is_neo_hookean() const;                    \
  template double CellBatches<dim>::add_neo_hooke(const Vector &, Vector &); \
  template std::shared_ptr<const CellBatches<dim>::Tangent>                  \
  CellBatches<dim>::tangent(const Vector &, const Vector *);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
