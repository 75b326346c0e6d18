// Displacements are carried to another mesh of the same elements, which may lie
// on other processes: by element and node, so that the two sides of a cut keep
// their own.

#include <setsudan/elasticity/transfer.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "../test_setup.h"
#include "small_model.h"

using namespace Setsudan;
using namespace dealii;

/** Give the cells behind `boundary` in x direction vertices of their own. */
template <int dim>
CoarseMesh<dim>
split(CoarseMesh<dim> mesh,
      const BoxNumbering<dim> &numbering,
      const unsigned int boundary)
{
  std::map<unsigned int, unsigned int> copies;
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    if (numbering.element_indices(cell)[0] >= boundary)
      for (unsigned int &vertex : mesh.cells[cell].vertices)
        {
          if (copies.emplace(vertex, mesh.vertices.size()).second)
            mesh.vertices.push_back(mesh.vertices[vertex]);
          vertex = copies[vertex];
        }
  return mesh;
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
        const bool behind = body.numbering.element_indices(element)[0] >= 1;
        const auto nodes  = discretization.node_indices(cell);
        for (unsigned int node = 0; node < nodes.size(); ++node)
          for (unsigned int c = 0; c < dim; ++c)
            action(
              nodes[node][c],
              value(body.mesh.node_position(element, node), c, behind, jump));
      }
}


/** Carry the values from one mesh to another, and compare. */
template <int dim>
void
test(const std::string &name,
     const Body<dim> &body,
     const CoarseMesh<dim> &mesh_from,
     const CoarseMesh<dim> &mesh_to,
     const double jump)
{
  const Discretization<dim> from(mesh_from, MPI_COMM_WORLD);
  const Discretization<dim> to(mesh_to, MPI_COMM_WORLD);
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
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
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
  const auto once      = split(body.mesh, body.numbering, 1);
  const auto twice     = split(once, body.numbering, 2);
  test("to the same mesh", body, body.mesh, body.mesh, 0.);
  test("to a cut mesh", body, body.mesh, once, 0.);
  test("from a cut mesh to one cut twice", body, once, twice, 7.);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test<2>("4, 3");
    test<3>("3, 2, 2");
  });
}
