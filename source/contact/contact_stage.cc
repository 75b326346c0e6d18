// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/contact_stage.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

template <int dim>
ContactStage<dim>::ContactStage(const ContactBasis<dim> &basis,
                                const unsigned int row,
                                const unsigned int n_ahead,
                                const LAPACKFullMatrix<double> &all_products,
                                const UntouchedBody &without_contact)
  : basis(basis)
  , row(row)
  , place_of(basis.vectors().size(), numbers::invalid_unsigned_int)
  , vector_at(basis.vectors_of_stage(row, n_ahead))
{
  const unsigned int n = vector_at.size();
  for (unsigned int place = 0; place < n; ++place)
    place_of[vector_at[place]] = place;
  products.reinit(n);
  untouched = {{Vector<double>(n), Vector<double>(n)}, without_contact.energy};
  auto &[constant, slope] = untouched.displacements;
  for (unsigned int j = 0; j < n; ++j)
    {
      for (unsigned int i = j; i < n; ++i)
        products(i, j) = all_products(std::max(vector_at[i], vector_at[j]),
                                      std::min(vector_at[i], vector_at[j]));
      constant[j] = without_contact.displacements.constant[vector_at[j]];
      slope[j]    = without_contact.displacements.slope[vector_at[j]];
    }
  // In tiles, of which both halves stay in the cache.
  constexpr unsigned int tile = 32;
  for (unsigned int first = 0; first < n; first += tile)
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = first; i < std::min({first + tile, j, n}); ++i)
        products(i, j) = products(j, i);
}



template <int dim>
unsigned int
ContactStage<dim>::place_of_hat(const unsigned int hat,
                                const Wall wall,
                                const Component component) const
{
  return place_of[basis.vector_of_hat(hat, wall, component)];
}



template <int dim>
bool
ContactStage<dim>::can_move(const unsigned int h) const
{
  for (unsigned int v = basis.first_vector_of_hat(h);
       v < basis.first_vector_of_hat(h + 1);
       ++v)
    if (products(place_of[v], place_of[v]) != 0)
      return true;
  return false;
}



template struct ContactStage<2>;
template struct ContactStage<3>;
} // namespace Setsudan
