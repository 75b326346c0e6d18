// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/material/hyperelastic_law.h>
#include <setsudan/mechanics/strain_and_stress.h>
#include <setsudan/mechanics/stress/ellipticity.h>
#include <setsudan/mechanics/stress/stress_evaluator.h>

#include <boost/serialization/utility.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>
#include <vector>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Whether a material may lose ellipticity, as far as that is looked at. */
bool
may_lose_it(const Material &material)
{
  const auto *const law = material.law->hyperelastic();
  return law != nullptr && !law->is_polyconvex() && !material.is_mixed;
}



/** Unit vectors along the sides and diagonals of a cube, one of each two that
 * are opposite. */
template <int dim>
std::vector<Tensor<1, dim>>
directions_of_cube()
{
  std::vector<Tensor<1, dim>> directions;
  const unsigned int n = Utilities::pow(3, dim);
  for (unsigned int i = n / 2 + 1; i < n; ++i)
    {
      Tensor<1, dim> direction;
      unsigned int rest = i;
      for (unsigned int d = 0; d < dim; ++d, rest /= 3)
        direction[d] = static_cast<int>(rest % 3) - 1;
      directions.push_back(direction / direction.norm());
    }
  return directions;
}



/** The smallest eigenvalue of the acoustic tensor across a direction. */
template <int dim>
double
least_resistance(const Tensor<4, 3> &tangent, const Tensor<1, dim> &across)
{
  SymmetricTensor<2, dim> acoustic;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int k = 0; k <= i; ++k)
      for (unsigned int j = 0; j < dim; ++j)
        for (unsigned int l = 0; l < dim; ++l)
          acoustic[i][k] += tangent[i][j][k][l] * across[j] * across[l];
  // Sorted, the largest first.
  return eigenvectors(acoustic, SymmetricTensorEigenvectorMethod::jacobi)
    .back()
    .first;
}



/** Let the points of a cell count. */
template <int dim>
void
include_cell(const StressEvaluator<dim> &points,
             const Material &material,
             const unsigned int element,
             LeastEllipticity<dim> &least)
{
  static const auto of_cube = directions_of_cube<dim>();
  for (unsigned int p = 0; p < points.n_points(); ++p)
    {
      const Tensor<2, dim> gradient = points.gradient(p);
      const Tensor<2, dim> F        = gradient + unit_symmetric_tensor<dim>();
      if (!(determinant(F) > 0))
        continue;
      const auto tangent =
        material.law->hyperelastic()->respond(in_space(gradient)).tangent;
      auto directions = of_cube;
      for (const auto &pair :
           eigenvectors(symmetrize(transpose(F) * F),
                        SymmetricTensorEigenvectorMethod::jacobi))
        directions.push_back(pair.second);
      for (const auto &across : directions)
        if (const double ratio =
              least_resistance(tangent, across) / material.at_rest.mu;
            ratio < least.ratio)
          least = {ratio, element, points.point(p), across};
    }
}
} // namespace


template <int dim>
LeastEllipticity<dim>
find_least_ellipticity(const ElasticModel<dim> &model,
                       const LA::Vector &displacement)
{
  LeastEllipticity<dim> least;
  const auto &all = model.materials.all();
  if (std::none_of(all.begin(), all.end(), may_lose_it))
    return least;
  const auto &discretization = model.discretization;
  const LA::Vector u         = discretization.with_ghosts(displacement);
  StressEvaluator<dim> points(
    discretization, model.materials, gauss_points(discretization));
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const unsigned int element = discretization.element(cell);
        const auto &material       = model.materials.of_element(element);
        if (!may_lose_it(material))
          continue;
        points.reinit(cell, u);
        include_cell(points, material, element, least);
      }
  const auto of_processes = Utilities::MPI::all_gather(
    discretization.communicator,
    std::make_pair(std::make_pair(least.ratio, least.element),
                   std::make_pair(least.point, least.across)));
  for (const auto &[what, where] : of_processes)
    if (what.first < least.ratio)
      least = {what.first, what.second, where.first, where.second};
  return least;
}



template <int dim>
std::string
describe_ellipticity(const ElasticModel<dim> &model,
                     const LeastEllipticity<dim> &softest)
{
  const auto rounded = [](const Tensor<1, dim> &vector) {
    std::ostringstream text;
    text.precision(2);
    for (unsigned int d = 0; d < dim; ++d)
      text << (d == 0 ? "(" : ", ")
           << (std::abs(vector[d]) < 1e-6 ? 0. : vector[d]);
    return text.str() + ")";
  };
  std::ostringstream text;
  text
    << "the law " << model.materials.of_element(softest.element).law->name()
    << (softest.ratio > 0 ? " has hardly any resistance left"
                          : " has no resistance left (it has lost "
                            "ellipticity)")
    << " in element " << softest.element << " at " << rounded(softest.point)
    << " to a band across " << rounded(softest.across)
    << ": in such bands, as narrow as the elements are, a body collapses. "
       "Of Material/Law isochoric neo-Hooke, and neo-Hooke where Poisson's "
       "ratio is not negative, resist in any state, unless Volumetric energy "
       "is logarithmic.";
  return text.str();
}



#define INSTANTIATE(dim)                                               \
  template LeastEllipticity<dim> find_least_ellipticity(               \
    const ElasticModel<dim> &, const LA::Vector &);                    \
  template std::string describe_ellipticity(const ElasticModel<dim> &, \
                                            const LeastEllipticity<dim> &);

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
