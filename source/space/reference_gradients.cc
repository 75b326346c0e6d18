// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/space/reference_gradients.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
AlignedVector<double>
reference_gradients(const FiniteElement<dim> &element,
                    const unsigned int n_gauss_points)
{
  const QGauss<dim> rule(n_gauss_points);
  AlignedVector<double> gradients;
  for (const auto &point : rule.get_points())
    for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
      {
        const Tensor<1, dim> gradient = element.shape_grad(i, point);
        for (unsigned int d = 0; d < dim; ++d)
          gradients.push_back(gradient[d]);
      }
  return gradients;
}



template AlignedVector<double>
reference_gradients(const FiniteElement<2> &, const unsigned int);
template AlignedVector<double>
reference_gradients(const FiniteElement<3> &, const unsigned int);
} // namespace Setsudan
