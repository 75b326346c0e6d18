// SPDX-License-Identifier: LGPL-2.1-or-later
// The balance of forces and moments: it is even for a body at rest under its
// loads, and it tells by how much it is not where something is missing.

#include <setsudan/mechanics/balance.h>
#include <setsudan/solver/assembled_solver.h>

#include <algorithm>
#include <string>

#include "../test_setup.h"
#include "solved_model.h"

using namespace Setsudan;
using namespace dealii;

void
print(const std::string &name, const Balance &balance)
{
  const auto clean = [](const double value) {
    return value < 1e-12 ? 0. : value;
  };
  std::cout << name << ": force " << clean(balance.force_residual)
            << ", moment " << clean(balance.moment_residual) << std::endl;
}


/** The body is 1 x 2 x 4 long: moments are relative to 4 times the forces. */
void
test_resultant(const Discretization<3> &discretization)
{
  using Forces     = std::vector<PointForce<3>>;
  const auto print = [&](const std::string &name, const Forces &forces) {
    Resultant<3> resultant(discretization);
    for (const auto &[point, force] : forces)
      resultant.add(point, force);
    resultant.sum_over_processes();
    ::print(name, resultant.relative());
  };
  const auto e = [](const unsigned int axis, const double factor) {
    return factor * Point<3>::unit_vector(axis);
  };
  const Point<3> a(0, 0, 0), b(0, 1, 0), center(0.5, 1, 2);
  print("no force", {});
  print("one force in the centre", {{center, e(2, 3.)}});
  print("one force in a corner", {{a, e(2, 3.)}});
  print("two that cancel", {{a, e(2, 3.)}, {a + e(2, 1.), e(2, -3.)}});
  print("a couple", {{a, e(2, 3.)}, {b, e(2, -3.)}});
  print("a lever", {{a, e(2, 3.)}, {b, e(2, -4.)}, {a + e(1, 4.), e(2, 1.)}});
}


/** Of a body at rest: with all that acts on it; with the blade's force left
 * out, doubled, and moved; and with a displacement that is none of rest. */
template <int dim>
void
test_body_at_rest(const Assignments &assignments)
{
  SolvedModel<dim> solved(assignments);
  auto &model                = solved.model;
  const auto &discretization = model.discretization;
  // The nodal force of the assignments stands for the blade.
  const LA::Vector applied = model.loads;
  model.loads              = 0;
  const auto balance       = [&](const LA::Vector &displacement,
                           const std::vector<PointForce<dim>> &blade) {
    return check_balance(
      model,
      internal_forces(discretization,
                      model.stiffness,
                      discretization.with_ghosts(displacement)),
      applied,
      blade);
  };

  // A sixth of a body length beside where it acts, if it is moved.
  Point<dim> corner, beside;
  beside[0] = 1;
  Tensor<1, dim> force;
  force[dim - 1]  = -3;
  const auto &u   = solved.displacement;
  LA::Vector half = u;
  half *= 0.5;
  std::cout << dim << "D" << std::endl;
  print("at rest", balance(u, {{corner, force}}));
  print("without the blade", balance(u, {}));
  print("twice the blade", balance(u, {{corner, 2 * force}}));
  print("another place", balance(u, {{beside, force}}));
  print("half the displacement", balance(half, {{corner, force}}));
  std::cout << "reaction " << balance(u, {{corner, force}}).reaction[dim - 1]
            << std::endl;
}


/** Of a body with hanging nodes, some of them on the support and on a loaded
 * face: what acts there is handed on to their neighbors, with its moments. */
template <int dim>
void
test_hanging_nodes(const Assignments &assignments)
{
  const unsigned int last = dim == 3 ? 5 : 2;
  SolvedModel<dim> solved(assignments, {0, {{0, 1}, {last, 1}}});
  auto &model                = solved.model;
  const auto &discretization = model.discretization;
  const LA::Vector internal =
    internal_forces(discretization,
                    model.stiffness,
                    discretization.with_ghosts(solved.displacement));
  std::cout << dim << "D, " << discretization.triangulation.n_active_cells()
            << " cells, " << model.hanging.n_constraints()
            << " hanging unknowns" << std::endl;
  const auto balance = check_balance<dim>(model, internal, model.loads, {});
  print("at rest", balance);
  std::cout << "reaction " << balance.reaction[dim - 1] << std::endl;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_resultant(SmallModel<3>({"Body/Size=1,2,4", "Body/Elements=1,2,1"})
                     .model.discretization);
    test_body_at_rest<3>({"Body/Size=6,2,2",
                          "Body/Elements=3,1,1",
                          "Support/Fixed faces=right",
                          "Load/Nodal forces=0 : 0, 0, -3"});
    test_body_at_rest<2>({"Body/Size=6,2",
                          "Body/Elements=3,1",
                          "Support/Fixed faces=right",
                          "Load/Nodal forces=0 : 0, -3"});
    test_hanging_nodes<3>({"Body/Size=6,2,2",
                           "Body/Elements=3,2,1",
                           "Support/Fixed faces=right",
                           "Load/Body force=0, 0, -1",
                           "Load/Pressures=left : 2; top : 0.5"});
    test_hanging_nodes<2>({"Body/Size=6,2",
                           "Body/Elements=3,2",
                           "Support/Fixed faces=right",
                           "Load/Body force=0, -1",
                           "Load/Pressures=left : 2; top : 0.5"});
  });
}
