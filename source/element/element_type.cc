// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/fe/fe_q.h>

#include <setsudan/element/element_type.h>
#include <setsudan/element/fe_q_serendipity.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
std::unique_ptr<FiniteElement<dim>>
make_element(const ElementType type)
{
  switch (type)
    {
      case ElementType::linear:
        return std::make_unique<FE_Q<dim>>(1);
      case ElementType::quadratic:
        return std::make_unique<FE_Q<dim>>(2);
      case ElementType::serendipity:
        break;
    }
  return std::make_unique<FE_Q_Serendipity<dim>>();
}



template std::unique_ptr<FiniteElement<2>>
make_element<2>(const ElementType);
template std::unique_ptr<FiniteElement<3>>
make_element<3>(const ElementType);
} // namespace Setsudan
