// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/elastic_model.h>

#include <cmath>
#include <string>

#include "../test_setup.h"
#include "small_model.h"

namespace Setsudan
{
using namespace dealii;

/** A displacement that has no symmetry and is the same on any number of
 * processes. */
template <int dim>
LA::Vector
random_displacement(const Discretization<dim> &discretization)
{
  return nodal_values(discretization, [](const Point<dim> &p) {
    Tensor<1, dim> u;
    for (unsigned int c = 0; c < dim; ++c)
      u[c] = std::sin(37 * p[0] + 53 * p[1] + 19 * p[dim - 1] + 5 * c);
    return u;
  });
}


/** The same, of some size. */
template <int dim>
LA::Vector
deformed(const Discretization<dim> &discretization, const double size)
{
  LA::Vector u = random_displacement(discretization);
  u *= size;
  return u;
}


/** Visit small models of all shapes, elements and materials that the kernels
 * tell apart.
 *
 * @param visit called with the model and its name. */
template <int dim, typename Visit>
void
for_each_small_model(const Visit &visit)
{
  const std::string n       = dim == 2 ? "3,5" : "3,5,2";
  const CoarseMesh<dim> box = SmallBody<dim>({"Body/Elements=" + n}).body.mesh;
  const CoarseMesh<dim> uneven = distorted(box), bent = curved(uneven);
  const auto visit_one = [&](const std::string &name,
                             const CoarseMesh<dim> *mesh,
                             Assignments assignments) {
    assignments.push_back("Body/Elements=" + n);
    SmallModel<dim> small(assignments, mesh);
    visit(std::to_string(dim) + "D, " + name, small.model);
  };
  visit_one("box", nullptr, {});
  visit_one("distorted", &uneven, {});
  visit_one("curved", &bent, {});
  for (const std::string formulation : {"displacement", "mixed"})
    {
      const Assignments nearly{"Material/Poisson's ratio=0.4999",
                               "Material/Formulation=" + formulation};
      visit_one("nu = 0.4999, box, " + formulation, nullptr, nearly);
      visit_one("nu = 0.4999, curved, " + formulation, &bent, nearly);
    }
  visit_one("quadratic", &uneven, {"Body/Element type=quadratic"});
}


/** Those in two and three dimensions, and linear elements.
 *
 * @param visit called with the name and the model. */
template <typename Visit>
void
for_each_model(const Visit &visit)
{
  for_each_small_model<2>(visit);
  for_each_small_model<3>(visit);
  const std::string linear = "Body/Element type=linear";
  SmallModel<2> square(Assignments{"Body/Elements=3,2", linear});
  visit("2D, linear", square.model);
  SmallModel<3> cube(Assignments{"Body/Elements=2,2,2", linear});
  visit("3D, linear", cube.model);
}
} // namespace Setsudan
