// SPDX-License-Identifier: LGPL-2.1-or-later
// Newton's method under finite strain: how many steps it takes, in one part and
// in several, and where there is no stable equilibrium.

#include <setsudan/parameters/exceptions.h>
#include <setsudan/solver/newton_solver.h>

#include <memory>
#include <string>

#include "../mechanics/small_model.h"
#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

template <int dim>
struct Loaded : SmallModel<dim>
{
  static void
  declare(ParameterHandler &handler)
  {
    SmallModel<dim>::declare(handler);
    SolverParameters::declare(handler);
  }

  /** On the elements of `mesh`, or on a box. */
  explicit Loaded(const Assignments &assignments,
                  const CoarseMesh<dim> *mesh = nullptr)
    : Loaded(parameters_of(assignments, declare), mesh)
  {
  }

  Loaded(const Parameters &parameters, const CoarseMesh<dim> *mesh)
    : SmallModel<dim>(parameters, mesh)
    , solver_parameters(parameters)
  {
  }

  /** Solve under a part of the loads. */
  Solution
  solve(const double part, const LA::Vector &start) const
  {
    return solve(part, start, this->model.lift);
  }

  /** The same with any displacement of the supports. */
  Solution
  solve(const double part,
        const LA::Vector &start,
        const LA::Vector &lift) const
  {
    auto constraints = std::make_shared<AffineConstraints<double>>(
      this->model.discretization.relevant);
    constraints->merge(this->model.supports);
    constraints->close();
    LA::Vector forces = this->model.loads;
    forces *= part;
    return NewtonSolver<dim>(this->model, constraints, solver_parameters)
      .solve(forces, lift, start);
  }

  Solution
  solve(const double part) const
  {
    return solve(part, this->model.discretization.zero_vector());
  }

  const SolverParameters solver_parameters;
};


/** Steps to a solution, of which there are not to be more than `most`. */
template <int dim>
void
test_steps(const std::string &name,
           const Assignments &assignments,
           const unsigned int most,
           const CoarseMesh<dim> *mesh = nullptr)
{
  const Loaded<dim> loaded(assignments, mesh);
  const auto solution = loaded.solve(1);
  say(name + ": " +
      (solution.n_steps <= most
         ? "at most " + std::to_string(most)
         : "FAILED, " + std::to_string(solution.n_steps)) +
      " steps");
  check_below_on_all("  residual", solution.quality.residual, 1e-10);
  // In two halves it is the same state.
  LA::Vector difference =
    loaded.solve(1, loaded.solve(0.5).displacement).displacement;
  difference -= solution.displacement;
  check_below_on_all("  by way of half the load",
                     difference.linfty_norm() /
                       solution.displacement.linfty_norm(),
                     1e-8);
}


/** Cook's membrane, of a body that hardly changes its volume, under its whole
 * load at once. */
void
test_membrane(const unsigned int n, const unsigned int most)
{
  const std::string elements =
    "Body/Elements=" + std::to_string(n) + "," + std::to_string(n);
  auto mesh = SmallBody<2>({elements, "Body/Size=1,1"}).body.mesh;
  for (auto &p : mesh.vertices)
    p = {48 * p[0], 44 * p[0] * (1 - p[1]) + (44 + 16 * p[0]) * p[1]};
  // mu = 80.1938 and kappa = 400942.
  test_steps<2>("membrane, " + std::to_string(n) + " x " + std::to_string(n),
                {elements,
                 "Body/Size=1,1",
                 "Support/Fixed faces=left",
                 "Load/Tractions=right : 0, 6.25",
                 "Material/Young's modulus=240.565",
                 "Material/Poisson's ratio=0.4999",
                 "Deformation/Strain=finite"},
                most,
                &mesh);
}


/** A load that vanishes leaves the body as it was at rest. */
void
test_unloading()
{
  const Loaded<3> loaded({"Body/Elements=2,2,2",
                          "Support/Fixed faces=bottom",
                          "Load/Tractions=top : 0.5, 0, 0.5",
                          "Deformation/Strain=finite"});
  const auto bent = loaded.solve(1), back = loaded.solve(0, bent.displacement);
  check_below_on_all("without load again",
                     back.displacement.linfty_norm() /
                       bent.displacement.linfty_norm(),
                     1e-8);
}


/** A column buckles under its load: the straight one is not taken. */
template <int dim>
void
test_buckling(const Assignments &assignments)
{
  const Loaded<dim> loaded(assignments);
  try
    {
      loaded.solve(1);
      say("FAILED: a state that is not stable was taken");
    }
  catch (const NoEquilibriumError &error)
    {
      const std::string message = error.what();
      const auto beyond         = message.find("beyond ") + 7;
      say(std::to_string(dim) + "D column: " +
          (message.find("gives way along") != std::string::npos ? "gives way"
                                                                : message));
      // Euler's load, pi^2 EI / (4 L^2), is a tenth of the load, and a little
      // less for a column that shortens.
      check_below_on_all("  part of the load",
                         std::abs(std::stod(message.substr(beyond)) - 0.1),
                         0.02);
    }
}


/** A state that is reached in one step is asked whether it is stable, too: the
 * law of St. Venant and Kirchhoff loses its resistance under compression. */
void
test_collapse()
{
  for (const std::string law : {"linear elastic", "neo-Hooke"})
    try
      {
        const Loaded<3> loaded(
          {"Body/Elements=1,1,2",
           "Support/Fixed components=left : x; right : x; front : y; back : y; "
           "bottom : z",
           "Support/Displacements=top : free, free, -5",
           "Material/Law=" + law,
           "Deformation/Strain=finite"});
        loaded.solve(1);
        say("block pressed to its half, " + law + ": taken");
      }
    catch (const NoEquilibriumError &error)
      {
        const std::string message = error.what();
        say("block pressed to its half, " + law + ": " +
            (message.find("hardly any resistance") != std::string::npos
               ? "the law is named"
               : message));
      }
}


/** A bar that is pulled to five times its length at once, of which linear
 * theory would say that its sides have passed through each other. */
void
test_long_bar()
{
  const Loaded<3> loaded(
    {"Body/Elements=1,1,1",
     "Support/Fixed components=left : x; front : y; bottom : z",
     "Support/Displacements=top : free, free, 40",
     "Material/Poisson's ratio=0.3",
     "Deformation/Strain=finite"});
  const auto solution = loaded.solve(1);
  double least        = 0;
  for (const double u : solution.displacement)
    least = std::min(least, u);
  // The lateral stretch of Ciarlet's law.
  check_below_on_all("pulled bar, sides", std::abs(least + 4.7083), 1e-3);
}


/** The displacement by which a body is turned about the origin. */
LA::Vector
turned(const ElasticModel<2> &model, const double angle)
{
  LA::Vector u = model.discretization.zero_vector();
  for (const auto &cell :
       model.discretization.dof_handler.active_cell_iterators())
    {
      const auto positions = model.discretization.node_positions(cell);
      const auto indices   = model.discretization.node_indices(cell);
      for (unsigned int n = 0; n < indices.size(); ++n)
        {
          const auto &x = positions[n];
          u(indices[n][0]) =
            (std::cos(angle) - 1) * x[0] - std::sin(angle) * x[1];
          u(indices[n][1]) =
            std::sin(angle) * x[0] + (std::cos(angle) - 1) * x[1];
        }
    }
  u.compress(VectorOperation::insert);
  return u;
}


/** A bar whose foot is turned once around, in twelve steps, follows without
 * being strained, and is where it was in the end. */
void
test_rotation(const std::string &ratio)
{
  const Loaded<2> loaded({"Body/Size=1,4",
                          "Body/Elements=1,3",
                          "Support/Fixed faces=bottom",
                          "Material/Poisson's ratio=" + ratio,
                          "Deformation/Strain=finite"});
  constexpr unsigned int n_steps = 12;
  LA::Vector u                   = loaded.model.discretization.zero_vector();
  double error = 0, energy = 0;
  for (unsigned int step = 1; step <= n_steps; ++step)
    {
      const LA::Vector expected =
        turned(loaded.model, 2 * numbers::PI * step / n_steps);
      u = loaded.solve(0, u, expected).displacement;
      energy =
        std::max(energy, evaluate_laws(loaded.model, u).energy.potential);
      LA::Vector difference = expected;
      difference -= u;
      error = std::max(error, difference.linfty_norm());
    }
  say("turned once around, Poisson's ratio " + ratio);
  check_below_on_all("  difference to a rotation", error, 1e-7);
  check_below_on_all("  energy", energy, 1e-12);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_membrane(4, 6);
    test_membrane(8, 6);
    test_steps<3>("pulled cube",
                  {"Body/Elements=2,2,2",
                   "Support/Fixed faces=bottom",
                   "Load/Tractions=top : 0.1, 0, 0.5",
                   "Deformation/Strain=finite"},
                  6);
    test_unloading();
    test_collapse();
    test_long_bar();
    test_rotation("0.2");
    test_rotation("0.4999999");
    // E I = 5 / 12 and L = 20: Euler's load is 0.00257.
    test_buckling<3>({"Body/Size=1,1,20",
                      "Body/Elements=1,1,10",
                      "Support/Fixed faces=bottom",
                      "Load/Tractions=top : 0, 0, -0.0257",
                      "Material/Poisson's ratio=0",
                      "Deformation/Strain=finite"});
    test_buckling<2>({"Body/Size=1,20",
                      "Body/Elements=1,10",
                      "Support/Fixed faces=bottom",
                      "Load/Tractions=top : 0, -0.0257",
                      "Material/Poisson's ratio=0",
                      "Deformation/Strain=finite"});
  });
}
