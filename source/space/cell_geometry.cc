// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/space/cell_geometry.h>

#include <cmath>

namespace Setsudan
{
using namespace dealii;

template <int dim>
CellGeometry<dim>::CellGeometry(const Discretization<dim> &discretization)
  : shapes(discretization)
  , no_element(0)
  , fe_values(discretization.mapping(),
              no_element,
              QGauss<dim>(discretization.n_gauss_points()),
              update_inverse_jacobians | update_JxW_values |
                update_quadrature_points)
{
}



template <int dim>
bool
CellGeometry<dim>::reinit(const Cell &cell)
{
  if (shapes.is_last(cell))
    return true;
  fe_values.reinit(
    static_cast<typename Triangulation<dim>::active_cell_iterator>(cell));
  basis.clear();
  find_gradients();
  return false;
}



template <int dim>
void
CellGeometry<dim>::find_gradients()
{
  scaled_gradients.clear();
  for (const unsigned int q : fe_values.quadrature_point_indices())
    {
      const double root   = std::sqrt(fe_values.JxW(q));
      const auto &inverse = fe_values.inverse_jacobian(q);
      for (unsigned int r = 0; r < dim; ++r)
        for (unsigned int d = 0; d < dim; ++d)
          scaled_gradients.push_back(root * inverse[r][d]);
    }
}



template <int dim>
void
CellGeometry<dim>::find_pressures()
{
  // 1, x, y, z made orthonormal in the sum over the points (Gram and Schmidt);
  // twice, so that flat cells do not lose digits.
  const unsigned int n_points = fe_values.n_quadrature_points;
  const auto at = [&](const unsigned int q, const unsigned int k) -> double & {
    return basis[q * (dim + 1) + k];
  };
  basis.resize(n_points * (dim + 1));
  const Point<dim> origin = fe_values.quadrature_point(0);
  for (unsigned int q = 0; q < n_points; ++q)
    for (unsigned int k = 0; k <= dim; ++k)
      at(q, k) =
        std::sqrt(fe_values.JxW(q)) *
        (k == 0 ? 1 : fe_values.quadrature_point(q)[k - 1] - origin[k - 1]);
  const auto product = [&](const unsigned int k, const unsigned int l) {
    double sum = 0;
    for (unsigned int q = 0; q < n_points; ++q)
      sum += at(q, k) * at(q, l);
    return sum;
  };
  for (unsigned int k = 0; k <= dim; ++k)
    for (unsigned int pass = 0; pass < 2; ++pass)
      {
        for (unsigned int l = 0; l < k; ++l)
          {
            const double part = product(k, l);
            for (unsigned int q = 0; q < n_points; ++q)
              at(q, k) -= part * at(q, l);
          }
        const double length = std::sqrt(product(k, k));
        for (unsigned int q = 0; q < n_points; ++q)
          at(q, k) /= length;
      }
}



template <int dim>
const std::vector<double> &
CellGeometry<dim>::gradients() const
{
  return scaled_gradients;
}



template <int dim>
const std::vector<double> &
CellGeometry<dim>::pressures()
{
  if (basis.empty())
    find_pressures();
  return basis;
}



template class CellGeometry<2>;
template class CellGeometry<3>;
} // namespace Setsudan
