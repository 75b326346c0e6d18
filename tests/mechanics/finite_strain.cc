// SPDX-License-Identifier: LGPL-2.1-or-later
// Forces and tangent of a body under finite strain are derivatives of its
// energy, with pressures that follow the surface; a rotation stores nothing;
// at rest the tangent is that of small strain.

#include <string>

#include "many_models.h"

using namespace Setsudan;

/** The energy from which forces follow. */
template <int dim>
double
potential(const ElasticModel<dim> &model, const LA::Vector &u)
{
  const auto of_laws = evaluate_laws(model, u);
  return of_laws.energy.potential + of_laws.potential_of_pressure;
}


template <int dim>
void
test_derivatives(const ElasticModel<dim> &model)
{
  constexpr double step      = 3e-5;
  const auto &discretization = model.discretization;
  const LA::Vector u         = deformed(discretization, 0.1);
  const LA::Vector d = nodal_values(discretization, [](const Point<dim> &p) {
    Tensor<1, dim> value;
    for (unsigned int c = 0; c < dim; ++c)
      value[c] = std::cos(2 * p[0] - p[dim - 1] + 3 * c);
    return value;
  });
  LA::Vector after = u, before = u;
  after.add(step, d);
  before.add(-step, d);
  const auto now     = evaluate_laws(model, u);
  const double slope = now.forces * d;
  check_below_on_all(
    "  forces",
    std::abs((potential(model, after) - potential(model, before)) / (2 * step) -
             slope) /
      std::abs(slope),
    1e-7);
  LA::Vector of_forces = evaluate_laws(model, after).forces;
  of_forces -= evaluate_laws(model, before).forces;
  of_forces /= 2 * step;
  const LA::Vector product = tangent_times(model, u, d);
  of_forces -= product;
  check_below_on_all(
    "  tangent", of_forces.l2_norm() / product.l2_norm(), 1e-6);
  const double one = u * product, other = d * tangent_times(model, u, u);
  check_below_on_all(
    "  tangent is symmetric", std::abs(one - other) / std::abs(one), 1e-12);
}


/** The tangent whose stress is extrapolated from the state itself is the exact
 * one, and from another state it is not. */
template <int dim>
void
test_extrapolation(const ElasticModel<dim> &model)
{
  const auto &discretization = model.discretization;
  const LA::Vector u         = deformed(discretization, 0.1),
                   zero      = discretization.zero_vector();
  AffineConstraints<double> none(discretization.relevant);
  none.close();
  LA::SparseMatrix exact, same, other;
  assemble_tangent(model, {&u}, none, exact);
  assemble_tangent(model, {&u, &u}, none, same);
  assemble_tangent(model, {&u, &zero}, none, other);
  const double size = exact.frobenius_norm();
  same.add(-1, exact);
  other.add(-1, exact);
  check_below_on_all(
    "  extrapolated from itself", same.frobenius_norm() / size, 1e-13);
  say(std::string("  extrapolated from rest: ") +
      (other.frobenius_norm() > 1e-8 * size ? "another one" : "the same"));
}


/** By 90 degrees about z, and in space by 40 degrees about x. */
template <int dim>
void
test_rotation(const ElasticModel<dim> &model, const double stiffness)
{
  const double angle = 40 * numbers::PI / 180;
  Tensor<2, dim> about_z, about_x = unit_symmetric_tensor<dim>();
  for (unsigned int c = 2; c < dim; ++c)
    about_z[c][c] = 1;
  about_z[0][1] = -1;
  about_z[1][0] = 1;
  if (dim == 3)
    {
      about_x[1][1] = about_x[dim - 1][dim - 1] = std::cos(angle);
      about_x[dim - 1][1]                       = std::sin(angle);
      about_x[1][dim - 1]                       = -std::sin(angle);
    }
  const LA::Vector u =
    nodal_values(model.discretization, [&](const Point<dim> &p) {
      return Tensor<1, dim>(about_z * (about_x * Tensor<1, dim>(p)) - p);
    });
  const auto rotated = evaluate_laws(model, u);
  check_below_on_all(
    "  rotated: energy", rotated.energy.potential / stiffness, 1e-12);
  check_below_on_all(
    "  rotated: forces", rotated.forces.linfty_norm() / stiffness, 1e-12);
}


/**
 * @param unprojected that of small strain in the displacement formulation: with
 *   finite strain the bulk modulus belongs to the projected change of volume,
 *   with small strain lambda, 2 mu / 3 less. Null where nothing is projected.
 */
template <int dim>
void
test_rest(const ElasticModel<dim> &finite,
          const ElasticModel<dim> &small,
          const ElasticModel<dim> *unprojected)
{
  const LA::Vector d    = deformed(finite.discretization, 1);
  const LA::Vector zero = finite.discretization.zero_vector();
  LA::Vector expected   = internal_forces(small, d);
  if (unprojected != nullptr)
    {
      const Hooke &hooke    = small.materials.of_element(0).at_rest;
      LA::Vector of_project = expected;
      of_project -= internal_forces(*unprojected, d);
      expected.add(2 * hooke.mu / (3 * hooke.lambda), of_project);
    }
  LA::Vector difference = tangent_times(finite, zero, d);
  difference -= expected;
  check_below_on_all("  tangent at rest: that of small strain",
                     difference.l2_norm() / expected.l2_norm(),
                     1e-12);
}


template <int dim>
void
test(const std::string &type, const std::string &law, const std::string &nu)
{
  const Assignments elements{dim == 3 ? "Body/Elements=2,1,1"
                                      : "Body/Elements=2,2",
                             "Body/Element type=" + type};
  Assignments body = elements;
  body.push_back("Material/Law=" + law);
  body.push_back("Material/Poisson's ratio=" + nu);
  body.push_back("Material/Ogden terms=0.63:1.3; 0.0012:5; -0.01:-2");
  Assignments of_finite = body, under_pressure;
  of_finite.push_back("Deformation/Strain=finite");
  under_pressure = of_finite;
  under_pressure.push_back(
    dim == 3 ? "Load/Pressures=left:1; right:1; front:1; back:1; bottom:1; "
               "top:1"
             : "Load/Pressures=left:1; right:1; bottom:1; top:1");
  const CoarseMesh<dim> uneven = distorted(SmallBody<dim>(elements).body.mesh);
  SmallModel<dim> small(body, &uneven), finite(of_finite, &uneven),
    loaded(under_pressure, &uneven);
  say(std::to_string(dim) + "D, " + type + ", " + law + ", nu = " + nu);
  test_derivatives(finite.model);
  test_derivatives(loaded.model);
  test_extrapolation(finite.model);
  test_rotation(finite.model, 5 * 10 * (nu == "0.49" ? 100 : 1));
  body.push_back("Material/Formulation=displacement");
  SmallModel<dim> unprojected(body, &uneven);
  test_rest(
    finite.model, small.model, nu == "0.49" ? &unprojected.model : nullptr);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for (const std::string type : {"linear", "serendipity", "quadratic"})
      {
        test<2>(type, "auto", "0.3");
        test<3>(type, "auto", "0.3");
        test<2>(type, "auto", "0.49");
        test<3>(type, "auto", "0.49");
      }
    for (const std::string law : {"linear elastic", "isochoric neo-Hooke"})
      test<3>("serendipity", law, "0.3");
    for (const std::string law : {"Mooney-Rivlin", "Ogden"})
      {
        test<2>("serendipity", law, "0.3");
        test<3>("serendipity", law, "0.49");
      }
  });
}
