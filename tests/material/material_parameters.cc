// SPDX-License-Identifier: LGPL-2.1-or-later
// Materials of parts of the body: which element has which, and a bar of two
// materials one behind the other.

#include <setsudan/material/material_parameters.h>
#include <setsudan/solver/assembled_solver.h>

#include <algorithm>
#include <cmath>

#include "../mechanics/small_model.h"
#include "../parameters/check.h"
#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

/** A row of 6 elements, some of them in groups; and a group that is none of
 * elements, and one that is empty. */
Body<2>
body_with_groups()
{
  Body<2> body = make_box<2>(Point<2>(6, 1), {{6, 1}});
  body.groups.push_back({"cream", 7, 2, {2, 3}, {}});
  body.groups.push_back({"jam: red", 8, 2, {3, 4}, {}});
  body.groups.push_back({"", 9, 2, {0, 1, 2, 5}, {}});
  body.groups.push_back({"air", 10, 2, {}, {}});
  return body;
}


MaterialParameters<2>
materials_of(const Assignments &assignments)
{
  return MaterialParameters<2>(
    parameters_of(assignments, MaterialParameters<2>::declare),
    body_with_groups());
}


/** Number, E, nu and shear limit of each element. */
void
print(const Assignments &assignments)
{
  const auto materials = materials_of(assignments);
  for (const auto &assignment : assignments)
    std::cout << assignment << " ";
  std::cout << std::endl;
  for (unsigned int element = 0; element < 6; ++element)
    {
      const auto &material = materials.of_element(element);
      const double lambda = material.at_rest.lambda, mu = material.at_rest.mu;
      std::cout << (element == 0 ? "  " : ", ") << materials.number(element)
                << ": " << mu * (3 * lambda + 2 * mu) / (lambda + mu) << " "
                << lambda / (2 * (lambda + mu)) << " "
                << material.shear_limit.smallest(2);
    }
  std::cout << "; smallest limit " << materials.smallest_shear_limit()
            << std::endl;
}


void
test_values()
{
  print({});
  print({"Material/Young's modulus=5; cream : 0.5"});
  // Later items win; what stands for all elements comes first.
  print({"Material/Shear limit=1; cream : 3; jam: red : 2",
         "Material/Poisson's ratio=0.25; 9 : 0"});
  // Elements of the same values are of the same material.
  print({"Material/Young's modulus=5; cream : 5; jam: red : 2"});
  // Groups that leave nothing out need no number without a group.
  print({"Material/Young's modulus=9 : 1; cream : 2; jam: red : 3"});
}


void
test_refusals()
{
  const auto refuse = [](const std::string &assignment) {
    print_refusal([&] { materials_of({assignment}); });
  };
  refuse("Material/Young's modulus=cream : 1");
  refuse("Material/Young's modulus=5; 6");
  refuse("Material/Young's modulus=cream : 1; 5");
  refuse("Material/Young's modulus=5; cream : 0");
  refuse("Material/Young's modulus=5; cream : soft");
  refuse("Material/Young's modulus=5; cream");
  refuse("Material/Young's modulus=5; butter : 1");
  refuse("Material/Young's modulus=5; air : 1");
  refuse("Material/Young's modulus=5; left : 1");
  refuse("Material/Young's modulus=");
  refuse("Material/Poisson's ratio=0.2; cream : 0.5");
  refuse("Material/Shear limit=1; cream : -1");
  refuse("Material/Linear range=0");
}


/** Pulled by a stress of 0.2, without lateral contraction: each element is
 * stretched by its own modulus. */
void
test_bar()
{
  const Assignments assignments = {
    "Material/Young's modulus=5; cream : 0.5; jam: red : 2",
    "Material/Poisson's ratio=0",
    "Support/Fixed faces=left",
    "Load/Tractions=right : 0.2, 0"};
  const auto declare = [](ParameterHandler &handler) {
    SmallModel<2>::declare(handler);
    SolverParameters::declare(handler);
  };
  const Parameters parameters = parameters_of(assignments, declare);
  const Body<2> body          = body_with_groups();
  const Supports<2> supports(SupportParameters<2>(parameters, body), body);
  const LoadParameters<2> loads(parameters, body);
  const MaterialParameters<2> materials(parameters, body);
  ElasticModel<2> model(
    body.mesh, {1, {}}, body, supports, loads, materials, MPI_COMM_WORLD);
  const auto &discretization = model.discretization;
  const LA::Vector zero      = discretization.zero_vector();
  const LA::Vector u         = discretization.with_ghosts(
    AssembledSolver<2>(
      model,
      model.supports,
      SolverParameters(parameters),
      choose_assembled(SolverParameters(parameters), size_of(discretization)))
      .solve(model.loads, zero, zero)
      .displacement);

  // Elements 0 and 1, 2, 3 and 4, 5 from left to right.
  const double stretch[] = {0.04, 0.04, 0.4, 0.1, 0.1, 0.04};
  double error           = 0;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    {
      const unsigned int element = discretization.element(cell);
      const auto nodes           = discretization.node_indices(cell);
      const auto positions       = discretization.node_positions(cell);
      for (unsigned int node = 0; node < nodes.size(); ++node)
        {
          double expected = stretch[element] * (positions[node][0] - element);
          for (unsigned int before = 0; before < element; ++before)
            expected += stretch[before];
          error = std::max(error, std::abs(u(nodes[node][0]) - expected));
          error = std::max(error, std::abs(u(nodes[node][1])));
        }
    }
  check_below("bar of several materials", error, 1e-12);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_values();
    test_refusals();
    test_bar();
  });
}
