// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacements are carried to another mesh of the same elements, which may lie
// on other processes: by element and node, so that the two sides of a cut keep
// their own. They are carried between refined meshes as well.

#include <setsudan/space/transfer.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "../body/detach.h"
#include "../mechanics/small_model.h"
#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

/** Give the cells behind `boundary` in x direction vertices of their own. */
template <int dim>
CoarseMesh<dim>
split(const CoarseMesh<dim> &mesh,
      const BoxNumbering<dim> &numbering,
      const unsigned int boundary)
{
  std::set<unsigned int> behind;
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    if (numbering.element_indices(cell)[0] >= boundary)
      behind.insert(cell);
  return detach(mesh, behind);
}


/** A value for each node, with a jump of `jump` behind `boundary`. */
template <int dim>
double
value(const Point<dim> &p,
      const unsigned int component,
      const bool behind,
      const double jump)
{
  return std::sin(p[0] + 2 * p[1] + 3 * p[dim - 1]) + component +
         (behind ? jump : 0);
}


/** Call `action(index, value)` for all unknowns of this process's cells. */
template <int dim, typename Action>
void
for_each_value(const Discretization<dim> &discretization,
               const Body<dim> &body,
               const double jump,
               const Action &action)
{
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const unsigned int element = discretization.element(cell);
        const bool behind          = body.box->element_indices(element)[0] >= 1;
        const auto nodes           = discretization.node_indices(cell);
        const auto positions       = discretization.node_positions(cell);
        for (unsigned int node = 0; node < nodes.size(); ++node)
          for (unsigned int c = 0; c < dim; ++c)
            action(nodes[node][c], value(positions[node], c, behind, jump));
      }
}


/** Carry the values from one mesh to another, and compare. */
template <int dim>
void
test(const std::string &name,
     const Body<dim> &body,
     const CoarseMesh<dim> &mesh_from,
     const CoarseMesh<dim> &mesh_to,
     const double jump,
     const Refinement &refinement = {})
{
  const Discretization<dim> from(mesh_from, refinement, MPI_COMM_WORLD);
  const Discretization<dim> to(mesh_to, refinement, MPI_COMM_WORLD);
  LA::Vector u = from.zero_vector();
  for_each_value<dim>(
    from, body, jump, [&](const auto index, const double value) {
      u.set(1, &index, &value);
    });
  u.compress(VectorOperation::insert);

  const LA::Vector carried =
    to.with_ghosts(transfer(from, from.with_ghosts(u), to));
  double error = 0;
  for_each_value<dim>(
    to, body, jump, [&](const auto index, const double value) {
      error = std::max(error, std::abs(carried(index) - value));
    });
  error = Utilities::MPI::max(error, MPI_COMM_WORLD);
  if (is_first_process())
    {
      std::cout << dim << "D, " << name << ": from "
                << from.dof_handler.n_dofs() << " to "
                << to.dof_handler.n_dofs() << " unknowns" << std::endl;
      check_below("difference", error, 0.);
    }
}


template <int dim>
void
test(const std::string &n_elements)
{
  const Body<dim> body = SmallBody<dim>({"Body/Elements=" + n_elements}).body;
  const auto once      = split(body.mesh, *body.box, 1);
  const auto twice     = split(once, *body.box, 2);
  test("to the same mesh", body, body.mesh, body.mesh, 0.);
  test("to a cut mesh", body, body.mesh, once, 0.);
  test("from a cut mesh to one cut twice", body, once, twice, 7.);
  test("refined, to a cut mesh", body, body.mesh, once, 0., {1, {}});
}


/** The largest difference of a field from `value` on this process's cells,
 * between their nodes as well. */
template <int dim>
double
field_error(
  const Discretization<dim> &discretization,
  const LA::Vector &field,
  const std::function<double(const Point<dim> &, unsigned int)> &value)
{
  FEValues<dim> fe_values(discretization.mapping(),
                          discretization.fe,
                          QGauss<dim>(3),
                          update_values | update_quadrature_points);
  std::vector<Vector<double>> values(fe_values.n_quadrature_points,
                                     Vector<double>(dim));
  double error = 0;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        fe_values.reinit(cell);
        fe_values.get_function_values(field, values);
        for (const unsigned int q : fe_values.quadrature_point_indices())
          for (unsigned int c = 0; c < dim; ++c)
            error = std::max(
              error,
              std::abs(values[q](c) - value(fe_values.quadrature_point(q), c)));
      }
  return Utilities::MPI::max(error, MPI_COMM_WORLD);
}


/**
 * Between a body that is refined near where it will be cut and the cut one: a
 * quadratic field, which is exact on both sides of hanging nodes; and any
 * field of the elements, which must come back as it was.
 */
template <int dim>
void
test_hanging_nodes(const std::string &n_elements, const Refinement &refinement)
{
  const SmallBody<dim> small(
    {"Body/Elements=" + n_elements,
     dim == 3 ? "Body/Size=3, 2, 2" : "Body/Size=4, 3"});
  const Body<dim> &body = small.body;
  const auto cut        = split(body.mesh, *body.box, 2);
  const Assignments none;
  const SmallModel<dim> before(none, &body.mesh, refinement);
  const SmallModel<dim> behind(none, &cut, refinement);
  const auto &from = before.model.discretization;
  const auto &to   = behind.model.discretization;

  const auto quadratic = [](const Point<dim> &p, const unsigned int c) {
    return p[0] * p[c] - 2 * p[1] * p[dim - 1] + c + 1;
  };
  LA::Vector u = nodal_values(from, [&](const Point<dim> &p) {
    Tensor<1, dim> values;
    for (unsigned int c = 0; c < dim; ++c)
      values[c] = quadratic(p, c);
    return values;
  });
  const LA::Vector carried =
    to.with_ghosts(transfer(from, from.with_ghosts(u), to));
  const double errors[] = {
    field_error<dim>(from, from.with_ghosts(u), quadratic),
    field_error<dim>(to, carried, quadratic)};

  // Any field whose hanging nodes follow their neighbors.
  for (const auto index : from.owned)
    u(index) += std::sin(1. + index);
  u.compress(VectorOperation::add);
  before.model.hanging.distribute(u);
  const LA::Vector there = transfer(from, from.with_ghosts(u), to);
  LA::Vector followed    = there;
  behind.model.hanging.distribute(followed);
  followed -= there;
  LA::Vector back = transfer(to, to.with_ghosts(there), from);
  back -= u;
  const double hanging_error = followed.linfty_norm();
  const double back_error    = back.linfty_norm();

  const unsigned int n_hanging =
    Utilities::MPI::max(before.model.hanging.n_constraints(), MPI_COMM_WORLD);
  const unsigned int n_cells[] = {from.triangulation.n_global_active_cells(),
                                  to.triangulation.n_global_active_cells()};
  if (is_first_process())
    {
      std::cout << dim << "D, with hanging nodes: from "
                << from.dof_handler.n_dofs() << " to "
                << to.dof_handler.n_dofs() << " unknowns, from " << n_cells[0]
                << " to " << n_cells[1] << " cells"
                << (n_hanging > 0 ? "" : ", but FAILED, none hangs")
                << std::endl;
      check_below("field before", errors[0], 1e-13);
      check_below("field behind", errors[1], 1e-13);
      check_below("hanging nodes follow", hanging_error, 1e-14);
      check_below("and back", back_error, 0.);
    }
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test<2>("4, 3");
    test<3>("3, 2, 2");
    // Both sides of the cut alike; the first of them once more.
    test_hanging_nodes<2>(
      "4, 3", {0, {{1, 1}, {1, 5}, {2, 1}, {2, 4}, {9, 1}, {10, 1}}});
    test_hanging_nodes<3>("3, 2, 2", {0, {{1, 1}, {2, 1}}});
    test_hanging_nodes<3>("3, 2, 2", {1, {{1, 9}, {2, 8}}});
  });
}
