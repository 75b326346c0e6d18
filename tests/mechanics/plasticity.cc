// SPDX-License-Identifier: LGPL-2.1-or-later
// Forces and tangent of a body that flows, and relaxes, are derivatives of its
// energy, in both formulations and with finite strain; below the limit they are
// those of the elastic body; a bar that is released stays as long as its
// plastic strain has made it.

#include <setsudan/mechanics/stress/deformation_extremes.h>
#include <setsudan/mechanics/stress/stress_evaluator.h>
#include <setsudan/solver/newton_solver.h>

#include <cmath>
#include <memory>
#include <string>

#include "many_models.h"

using namespace Setsudan;

template <int dim>
LA::Vector
wave(const Discretization<dim> &discretization, const double phase)
{
  return nodal_values(discretization, [&](const Point<dim> &p) {
    Tensor<1, dim> value;
    for (unsigned int c = 0; c < dim; ++c)
      value[c] = std::cos(2 * p[0] - p[dim - 1] + 3 * c + phase);
    return value;
  });
}


/** About a state that flows, behind one that has flown. */
template <int dim>
void
test_derivatives(const ElasticModel<dim> &model, const double size = 1)
{
  constexpr double step = 1e-6;
  evaluate_laws(model, deformed(model.discretization, 0.1));
  model.internal.accept();
  model.internal.set_time_step(0.3);
  LA::Vector u = wave(model.discretization, 0);
  u *= size;
  LA::Vector after = u, before = u;
  const LA::Vector d = wave(model.discretization, 1);
  after.add(step, d);
  before.add(-step, d);
  const auto now = evaluate_laws(model, u);
  say(std::string("  flows: ") + (now.energy.plastic > 0 ? "yes" : "FAILED"));
  const double slope = now.forces * d;
  check_below_on_all("  forces",
                     std::abs((evaluate_laws(model, after).energy.potential -
                               evaluate_laws(model, before).energy.potential) /
                                (2 * step) -
                              slope) /
                       std::abs(slope),
                     1e-6);
  LA::Vector of_forces = evaluate_laws(model, after).forces;
  of_forces -= evaluate_laws(model, before).forces;
  of_forces /= 2 * step;
  const LA::Vector product = tangent_times(model, u, d);
  of_forces -= product;
  check_below_on_all(
    "  tangent", of_forces.l2_norm() / product.l2_norm(), 1e-4);
  const double one = u * product, other = d * tangent_times(model, u, u);
  check_below_on_all(
    "  tangent is symmetric", std::abs(one - other) / std::abs(one), 1e-12);
}


template <int dim>
void
test_below_limit(const ElasticModel<dim> &model,
                 const ElasticModel<dim> &elastic)
{
  const LA::Vector u  = wave(model.discretization, 0);
  const auto now      = evaluate_laws(model, u);
  LA::Vector forces   = internal_forces(elastic, u);
  const double energy = u * forces / 2;
  check_below_on_all("  below the limit: energy",
                     std::abs(now.energy.potential / energy - 1),
                     1e-12);
  const double size = forces.l2_norm();
  forces -= now.forces;
  check_below_on_all(
    "  below the limit: forces", forces.l2_norm() / size, 1e-12);
  const auto extremes = find_extremes(model, u),
             expected = find_extremes(elastic, u);
  check_below_on_all("  below the limit: maximum shear",
                     std::abs(extremes.max_shear / expected.max_shear - 1),
                     1e-12);
}


template <int dim>
void
test(const std::string &type, const std::string &nu)
{
  const Assignments elements{dim == 3 ? "Body/Elements=2,1,1"
                                      : "Body/Elements=2,2",
                             "Body/Element type=" + type};
  Assignments elastic = elements;
  elastic.push_back("Material/Poisson's ratio=" + nu);
  Assignments flowing = elastic, stiff = elastic;
  flowing.push_back("Material/Yield stress=0.5");
  flowing.push_back("Material/Hardening=0.4, 0.3");
  stiff.push_back("Material/Yield stress=1e9");
  Assignments viscous = flowing;
  viscous.push_back("Material/Viscous=0.3 : 0.2, 0.1 : 2");
  viscous.push_back("Material/Viscous bulk=0.2 : 1");
  Assignments finite = viscous;
  finite.push_back("Deformation/Strain=finite");
  finite.push_back("Material/Yield stress=0.02");
  const CoarseMesh<dim> uneven = distorted(SmallBody<dim>(elements).body.mesh);
  SmallModel<dim> body(elastic, &uneven), plastic(flowing, &uneven),
    strong(stiff, &uneven);
  say(std::to_string(dim) + "D, " + type + ", nu = " + nu);
  test_derivatives(plastic.model);
  test_below_limit(strong.model, body.model);
  for (const bool is_finite : {false, true})
    {
      SmallModel<dim> relaxing(is_finite ? finite : viscous, &uneven);
      say(is_finite ? " and relaxes, finite strain" : " and relaxes");
      test_derivatives(relaxing.model, is_finite ? 0.15 : 1);
    }
}


/** The stresses at nodes and Gauss points, in one direction. */
double
largest_error(const ElasticModel<3> &model,
              const LA::Vector &displacement,
              const double expected)
{
  const LA::Vector u = model.discretization.with_ghosts(displacement);
  double error       = 0;
  for (const auto &points :
       {node_points(model.discretization), gauss_points(model.discretization)})
    {
      StressEvaluator<3> evaluator(
        model.discretization, model.materials, points, &model.internal);
      for (const auto &cell :
           model.discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            evaluator.reinit(cell, u);
            for (const auto &stress : evaluator.stresses())
              error = std::max(error, std::abs(stress[0][0] - expected));
          }
    }
  return error;
}


/** A bar that is pulled beyond its limit and released. */
void
test_bar(const std::string &nu, const std::string &hardening)
{
  constexpr double E = 5, limit = 0.02, H = 0.5, pull = 0.03, length = 2;
  const Assignments assignments{
    "Body/Size=2,1,1",
    "Body/Elements=2,1,1",
    "Material/Poisson's ratio=" + nu,
    "Material/Yield stress=0.02",
    "Material/Hardening=" + hardening,
    "Support/Fixed components=left : x; front : y; bottom : z",
    "Load/Pressures=right : -0.03"};
  const SmallModel<3> bar(assignments);
  const auto &model = bar.model;
  const SolverParameters parameters(
    parameters_of({}, SolverParameters::declare));
  auto constraints =
    std::make_shared<AffineConstraints<double>>(model.discretization.relevant);
  constraints->merge(model.supports);
  constraints->close();
  const auto solve = [&](const double part, const LA::Vector &start) {
    LA::Vector forces = model.loads;
    forces *= part;
    auto solution = NewtonSolver<3>(model, constraints, parameters)
                      .solve(forces, model.lift, start);
    evaluate_laws(model, solution.displacement);
    return solution.displacement;
  };
  const auto elongation = [&](const LA::Vector &u) {
    return u.linfty_norm() / length;
  };
  say("bar, nu = " + nu + ", hardening " + hardening);
  const double plastic    = (pull - limit) / H;
  const LA::Vector pulled = solve(1, model.discretization.zero_vector());
  check_below_on_all(
    "  pulled", std::abs(elongation(pulled) / (pull / E + plastic) - 1), 1e-9);
  check_below_on_all("  stress", largest_error(model, pulled, pull), 1e-10);
  model.internal.accept();
  check_below_on_all(
    "  stress when accepted", largest_error(model, pulled, pull), 1e-10);
  const LA::Vector released = solve(0, pulled);
  check_below_on_all(
    "  released", std::abs(elongation(released) / plastic - 1), 1e-9);
  const auto at_end = evaluate_laws(model, released);
  check_below_on_all(
    "  plastic energy",
    std::abs(at_end.energy.plastic / (length * (limit + pull) / 2 * plastic) -
             1),
    1e-8);
  check_below_on_all("  elastic energy", at_end.energy.stored, 1e-12);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for (const std::string type : {"linear", "serendipity", "quadratic"})
      for (const std::string nu : {"0.3", "0.49"})
        {
          test<2>(type, nu);
          test<3>(type, nu);
        }
    test_bar("0.3", "0.5, 0");
    test_bar("0.3", "0, 0.5");
    test_bar("0.49", "0.2, 0.3");
  });
}
