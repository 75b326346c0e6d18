// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/principal_axes.h>

#include <cmath>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** (f(x) - f(y)) / (x - y) of f = 1/2 ln. */
double
divided_difference(const double x, const double y)
{
  const double step = (x - y) / y;
  return (step == 0 ? 1 : std::log1p(step) / step) / (2 * y);
}



/** The second divided difference of 1/2 ln. */
double
divided_difference(double x, double y, double z)
{
  // Below this relative distance by a series about the mean, of which the first
  // term that is left out is round-off.
  constexpr double near          = 0.02;
  constexpr unsigned int n_terms = 9;
  if (x > y)
    std::swap(x, y);
  if (y > z)
    std::swap(y, z);
  if (x > y)
    std::swap(x, y);
  const double mean = (x + y + z) / 3;
  if (z - x > near * mean)
    return (divided_difference(y, z) - divided_difference(x, y)) / (z - x);
  // The k-th term of the series of ln(mean + d) is -(-1/mean)^k / k d^k, and
  // the divided difference of d^k the complete symmetric polynomial of degree
  // k - 2.
  const double a = (x - mean) / mean, b = (y - mean) / mean,
               c = (z - mean) / mean;
  double sum = 0, of_a = 1, of_ab = 1, of_abc = 1;
  for (unsigned int k = 2; k < 2 + n_terms; ++k)
    {
      sum += (k % 2 == 0 ? -1. : 1.) / k * of_abc;
      of_a *= a;
      of_ab  = b * of_ab + of_a;
      of_abc = c * of_abc + of_ab;
    }
  return sum / (2 * mean * mean);
}



/** Which component of a tensor each of the basis is. */
constexpr std::array<unsigned int, 6> row    = {{0, 1, 2, 0, 1, 2}};
constexpr std::array<unsigned int, 6> column = {{0, 1, 2, 1, 2, 0}};

/** How often it is in the tensor. */
double
weight(const unsigned int i)
{
  return i < 3 ? 1 : 2;
}
} // namespace


PrincipalAxes::PrincipalAxes(const Symmetric &C)
  : pairs(eigenvectors(C, SymmetricTensorEigenvectorMethod::jacobi))
{
  for (unsigned int i = 0; i < 6; ++i)
    {
      basis[i] = symmetrize(
        outer_product(pairs[row[i]].second, pairs[column[i]].second));
      first[i] = divided_difference(square(row[i]), square(column[i]));
    }
}



PrincipalAxes::Symmetric
PrincipalAxes::logarithm() const
{
  Symmetric strain;
  for (unsigned int a = 0; a < 3; ++a)
    strain += logarithm(a) * basis[a];
  return strain;
}



double
PrincipalAxes::logarithm(const unsigned int a) const
{
  return std::log(square(a)) / 2;
}



PrincipalAxes::Symmetric
PrincipalAxes::stress(const Symmetric &of_logarithm) const
{
  SymmetricTensor<2, 3> stress;
  for (unsigned int i = 0; i < 6; ++i)
    stress += 2 * weight(i) * first[i] * (of_logarithm * basis[i]) * basis[i];
  return stress;
}



SymmetricTensor<4, 3>
PrincipalAxes::tangent(const Symmetric &stress,
                       const SymmetricTensor<4, 3> &of_logarithm) const
{
  std::array<std::array<double, 3>, 3> along;
  std::array<SymmetricTensor<2, 3>, 6> of_basis;
  for (unsigned int i = 0; i < 6; ++i)
    {
      along[row[i]][column[i]] = along[column[i]][row[i]] = stress * basis[i];
      of_basis[i] = of_logarithm * basis[i];
    }
  SecondDifferences second;
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int b = 0; b < 3; ++b)
      for (unsigned int k = 0; k < 3; ++k)
        second[a][b][k] = divided_difference(square(a), square(b), square(k));
  SymmetricTensor<4, 3> by_C;
  for (unsigned int i = 0; i < 6; ++i)
    {
      // What the i-th change of C does to the stress.
      SymmetricTensor<2, 3> change;
      for (unsigned int j = 0; j < 6; ++j)
        change += weight(j) *
                  (first[i] * first[j] * (basis[j] * of_basis[i]) +
                   curvature(along, second, i, j)) *
                  basis[j];
      by_C += 4 * weight(i) * outer_product(basis[i], change);
    }
  return by_C;
}



double
PrincipalAxes::curvature(const std::array<std::array<double, 3>, 3> &stress,
                         const SecondDifferences &second,
                         const unsigned int i,
                         const unsigned int j)
{
  const auto entries = [](const unsigned int k) {
    return std::array<std::pair<unsigned int, unsigned int>, 2>{
      {{row[k], column[k]}, {column[k], row[k]}}};
  };
  double sum = 0;
  for (const auto &[a, k] : entries(i))
    for (const auto &[l, b] : entries(j))
      if (k == l)
        sum += stress[a][b] * second[a][k][b];
  return sum / 2;
}
} // namespace Setsudan
