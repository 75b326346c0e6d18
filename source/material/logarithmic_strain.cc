// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/material/logarithmic_strain.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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



/** The principal axes of C, and what is derived from its eigenvalues. */
class PrincipalAxes
{
public:
  explicit PrincipalAxes(const SymmetricTensor<2, 3> &C)
    : pairs(eigenvectors(C, SymmetricTensorEigenvectorMethod::jacobi))
  {
    for (unsigned int i = 0; i < 6; ++i)
      {
        basis[i] = symmetrize(
          outer_product(pairs[row[i]].second, pairs[column[i]].second));
        first[i] = divided_difference(square(row[i]), square(column[i]));
      }
  }

  SymmetricTensor<2, 3>
  logarithm() const
  {
    SymmetricTensor<2, 3> strain;
    for (unsigned int i = 0; i < 3; ++i)
      strain += std::log(square(i)) / 2 * basis[i];
    return strain;
  }

  /** The stress by C of that by its logarithm. */
  SymmetricTensor<2, 3>
  stress(const SymmetricTensor<2, 3> &of_logarithm) const
  {
    SymmetricTensor<2, 3> stress;
    for (unsigned int i = 0; i < 6; ++i)
      stress += 2 * weight(i) * first[i] * (of_logarithm * basis[i]) * basis[i];
    return stress;
  }

  /** The same of the tangent. */
  SymmetricTensor<4, 3>
  tangent(const SymmetricTensor<2, 3> &stress,
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

private:
  using SecondDifferences = std::array<std::array<std::array<double, 3>, 3>, 3>;

  static constexpr std::array<unsigned int, 6> row    = {{0, 1, 2, 0, 1, 2}};
  static constexpr std::array<unsigned int, 6> column = {{0, 1, 2, 1, 2, 0}};

  double
  square(const unsigned int i) const
  {
    return pairs[i].first;
  }

  /** How often a component is in a tensor. */
  static double
  weight(const unsigned int i)
  {
    return i < 3 ? 1 : 2;
  }

  /** Stress times the second derivative of the logarithm along two tensors of
   * the basis (Daleckii and Krein 1965). */
  double
  curvature(const std::array<std::array<double, 3>, 3> &stress,
            const SecondDifferences &second,
            const unsigned int i,
            const unsigned int j) const
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

  const std::array<std::pair<double, Tensor<1, 3>>, 3> pairs;
  std::array<SymmetricTensor<2, 3>, 6> basis;
  /** The first divided differences of the logarithm. */
  std::array<double, 6> first;
};
} // namespace


LogarithmicStrain::LogarithmicStrain(
  const std::shared_ptr<const SmallStrainLaw> &law)
  : law(law)
{
}



std::string
LogarithmicStrain::name() const
{
  return (law->linear() != nullptr ? "Hooke's law" : law->name()) +
         " of logarithmic strain";
}



LogarithmicStrain::Response
LogarithmicStrain::respond(const SymmetricTensor<2, 3> &C,
                           const double volume,
                           const History &history,
                           const bool needs_tangent) const
{
  const PrincipalAxes axes(C);
  const auto of_law = law->respond(axes.logarithm(), std::log(volume), history);
  Response response;
  response.energy      = of_law.energy;
  response.mean_stress = of_law.mean_stress / volume;
  response.stiffness = (of_law.lambda - of_law.mean_stress) / (volume * volume);
  const auto without_volume =
    of_law.stress - of_law.mean_stress * unit_symmetric_tensor<3>();
  response.distortion.stress = axes.stress(without_volume);
  if (needs_tangent)
    response.distortion.tangent = axes.tangent(without_volume, of_law.tangent);
  return response;
}



MaterialResponse
LogarithmicStrain::evaluate(const Tensor<2, 3> &gradient,
                            const History &history,
                            const bool needs_tangent) const
{
  const Tensor<2, 3> F = gradient + unit_symmetric_tensor<3>();
  const double J       = determinant(F);
  MaterialResponse response;
  if (!(J > 0))
    {
      response.energy.potential = std::numeric_limits<double>::infinity();
      return response;
    }
  const SymmetricTensor<2, 3> C = symmetrize(transpose(F) * F);
  auto of_law                   = respond(C, J, history, needs_tangent);
  StrainEnergy &all             = of_law.distortion;
  add_pressure(of_law.mean_stress, of_law.stiffness, J, invert(C), all);
  response.stress = F * all.stress;
  if (needs_tangent)
    response.tangent = tangent_in_gradient(F, all.stress, all.tangent);
  response.energy = of_law.energy;
  return response;
}
} // namespace Setsudan
