// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/scalar_polynomials_base.h>
#include <deal.II/base/tensor.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace Setsudan
{
/**
 * The quadratic serendipity polynomials on the unit cell @f$[0,1]^d@f$: the 3
 * (1D), 8 (2D) or 20 (3D) functions that are one at one node and zero at the
 * others. The nodes are the vertices and then the midpoints of the lines, both
 * in deal.II's order. In 3D these are the functions @f$N_0 \ldots N_{19}@f$ of
 * Kakefuda et al. (1996), equations (1) and (2), on another unit cell and in
 * another order; in 1D they are the traces on the faces of a 2D cell.
 *
 * The functions span the monomials of superlinear degree at most two; the
 * superlinear degree counts only the variables that enter with a power of at
 * least two (Arnold and Awanou, The serendipity family of finite elements,
 * Found. Comput. Math. 11, 2011). So @f$x^2 y z@f$ belongs to the space and
 * @f$x^2 y^2@f$ does not.
 */
template <int dim>
class SerendipityPolynomials : public dealii::ScalarPolynomialsBase<dim>
{
public:
  /** Compute the coefficients of the functions. */
  SerendipityPolynomials();

  /** The nodes on the unit cell, in the order of the functions. */
  static std::vector<dealii::Point<dim>>
  nodes();

  /**
   * All functions at @p unit_point. Each vector has either one entry for each
   * function or none; what is empty is not computed.
   */
  void
  evaluate(
    const dealii::Point<dim> &unit_point,
    std::vector<double> &values,
    std::vector<dealii::Tensor<1, dim>> &grads,
    std::vector<dealii::Tensor<2, dim>> &grad_grads,
    std::vector<dealii::Tensor<3, dim>> &third_derivatives,
    std::vector<dealii::Tensor<4, dim>> &fourth_derivatives) const override;

  /** The value of function @p i at @p p. */
  double
  compute_value(const unsigned int i,
                const dealii::Point<dim> &p) const override;

  /** The gradient of function @p i at @p p. */
  dealii::Tensor<1, dim>
  compute_1st_derivative(const unsigned int i,
                         const dealii::Point<dim> &p) const override;

  /** The second derivatives of function @p i at @p p. */
  dealii::Tensor<2, dim>
  compute_2nd_derivative(const unsigned int i,
                         const dealii::Point<dim> &p) const override;

  /** The third derivatives of function @p i at @p p. */
  dealii::Tensor<3, dim>
  compute_3rd_derivative(const unsigned int i,
                         const dealii::Point<dim> &p) const override;

  /** The fourth derivatives of function @p i at @p p. */
  dealii::Tensor<4, dim>
  compute_4th_derivative(const unsigned int i,
                         const dealii::Point<dim> &p) const override;

  /** The same as compute_1st_derivative(). */
  dealii::Tensor<1, dim>
  compute_grad(const unsigned int i,
               const dealii::Point<dim> &p) const override;

  /** The same as compute_2nd_derivative(). */
  dealii::Tensor<2, dim>
  compute_grad_grad(const unsigned int i,
                    const dealii::Point<dim> &p) const override;

  /** "SerendipityPolynomials". */
  std::string
  name() const override;

  /** A copy of this object. */
  std::unique_ptr<dealii::ScalarPolynomialsBase<dim>>
  clone() const override;

private:
  /** The power of each variable in a monomial, or the order of a derivative
   * with respect to each variable. */
  using Exponents = std::array<unsigned int, dim>;

  /** The exponents of all monomials of superlinear degree at most two. */
  static std::vector<Exponents>
  monomials();

  /** The derivative of the monomial with these @p exponents. */
  static double
  monomial_derivative(const Exponents &exponents,
                      const Exponents &orders,
                      const dealii::Point<dim> &p);

  /** One mixed derivative of function @p i, its value if all @p orders are
   * zero. */
  double
  mixed_derivative(const unsigned int i,
                   const Exponents &orders,
                   const dealii::Point<dim> &p) const;

  /** All derivatives of one order of function @p i. */
  template <int order>
  dealii::Tensor<order, dim>
  all_derivatives(const unsigned int i, const dealii::Point<dim> &p) const;

  /** The same of all functions. */
  std::vector<double>
  mixed_derivatives(const Exponents &orders, const dealii::Point<dim> &p) const;

  /** All derivatives of one order of all functions, or of none where `results`
   * is empty. */
  template <int order>
  void
  fill_derivatives(const dealii::Point<dim> &p,
                   std::vector<dealii::Tensor<order, dim>> &results) const;

  const std::vector<Exponents> exponents;

  /** Entry (m, i) is the coefficient of monomial m in function i. */
  dealii::FullMatrix<double> coefficients;
};
} // namespace Setsudan
