// SPDX-License-Identifier: LGPL-2.1-or-later
// Process zones: weights that sum up to the closed form of a ball, a half ball
// at a face, and a quarter at an edge; on small and on large cells; and the
// measures of stress that criteria compare.

#include <setsudan/cut/yield/cutting_stress.h>
#include <setsudan/cut/yield/process_zone.h>

#include <deal.II/base/mpi.h>

#include <cmath>

#include "../mechanics/small_model.h"
#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

/** The integral of (1 - (r/R)^2)^2 over a ball or disc. */
template <int dim>
double
weight_of_ball(const double radius)
{
  return dim == 3 ? 4 * numbers::PI * std::pow(radius, 3) * 8 / 105
                  : numbers::PI * radius * radius / 3;
}


/** Of a simple shear that grows with the height: the mean over a zone that is
 * symmetric about its center is the value there. */
template <int dim>
void
test_zone(const std::string &n_elements, const double radius)
{
  const SmallModel<dim> small(
    {"Body/Elements=" + n_elements, "Material/Shear limit=2"});
  const auto &discretization = small.model.discretization;
  const LA::Vector u         = discretization.with_ghosts(
    nodal_values(discretization, [](const Point<dim> &p) {
      Point<dim> value;
      value[0] = p[dim - 1] * p[dim - 1];
      return value;
    }));
  Point<dim> center, on_face;
  for (unsigned int d = 0; d < dim; ++d)
    center[d] = 5.1;
  on_face            = center;
  on_face[0]         = 0;
  Point<dim> at_edge = on_face;
  if (dim == 3)
    at_edge[1] = 0;

  const auto stresses = stresses_in_zones<dim>(
    small.model, {{center, {}}, {on_face, {}}, {at_edge, {}}}, radius, u);
  std::vector<double> weights(3);
  for (const auto &sample : stresses.samples)
    weights[sample.zone] += sample.weight;
  Utilities::MPI::sum(weights, MPI_COMM_WORLD, weights);
  const double ball = weight_of_ball<dim>(radius);
  check_below_on_all("  ball", std::abs(weights[0] / ball - 1), 0.02);
  check_below_on_all("  half", std::abs(weights[1] / (ball / 2) - 1), 0.02);
  if (dim == 3)
    check_below_on_all(
      "  quarter", std::abs(weights[2] / (ball / 4) - 1), 0.02);

  const auto stress = cutting_stress(
    YieldParameters::Criterion::mean_shear, stresses, 0.25, MPI_COMM_WORLD);
  // The shear modulus is 5 / 2.4.
  const double expected = 5 / 2.4 * 2 * 5.1;
  check_below_on_all(
    "  mean shear", std::abs(stress.reached / expected - 1), 0.002);
  check_below_on_all("  required", std::abs(stress.required - 1.5), 1e-12);
}


void
test_measures()
{
  using Criterion = YieldParameters::Criterion;
  FrontStress pull{}, press{}, shear{};
  pull.normal[0] = press.normal[0] = shear.normal[0] = 1;
  pull.stress[0][0]                                  = 3;
  press.stress[0][0]                                 = -3;
  shear.stress[0][1]                                 = 2;
  FrontStress both                                   = shear;
  both.stress[0][0]                                  = 1.5;
  for (const auto &[name, criterion] : std::map<std::string, Criterion>{
         {"maximum shear", Criterion::maximum_shear},
         {"von Mises", Criterion::von_mises},
         {"traction on the cut", Criterion::traction}})
    std::cout << name << ": pull " << stress_measure(criterion, pull)
              << ", pressure " << stress_measure(criterion, press) << ", shear "
              << stress_measure(criterion, shear) << ", pull and shear "
              << stress_measure(criterion, both) << std::endl;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    const bool speaks = is_first_process();
    if (speaks)
      {
        test_measures();
        std::cout << "2D, small cells" << std::endl;
      }
    test_zone<2>("40, 40", 2.);
    if (speaks)
      std::cout << "2D, large cells" << std::endl;
    test_zone<2>("3, 3", 2.);
    if (speaks)
      std::cout << "3D, large cells" << std::endl;
    test_zone<3>("3, 2, 3", 2.);
    try
      {
        test_zone<3>("1, 1, 1", 0.01);
      }
    catch (const std::runtime_error &error)
      {
        if (speaks)
          std::cout << error.what() << std::endl;
      }
  });
}
