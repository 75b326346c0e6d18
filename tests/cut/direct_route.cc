// SPDX-License-Identifier: LGPL-2.1-or-later
// Stages of cuts along x and z against the direct route: a list of nodes that
// is duplicated from the start, without seam, constraints or surgery. An opened
// pair shares the unknown of its normal component, up to the opening.

#include <deal.II/lac/lapack_full_matrix.h>

#include <setsudan/simulation/state.h>

#include <cmath>

#include "../test_setup.h"

using namespace Setsudan;

namespace
{
struct Case
{
  std::string elements, surface, direction, supports, loads;
  unsigned int axis, along;
  double sign;
};

// A node of the direct route: its number, and whether it is the + copy.
using Node = std::pair<unsigned int, bool>;

class DirectRoute
{
public:
  DirectRoute(const Scene<3> &scene, const Case &c, const double front)
    : scene(scene)
    , c(c)
    , front(front)
  {
  }

  // The displacement of every node of every element.
  std::map<std::pair<unsigned int, unsigned int>, dealii::Tensor<1, 3>>
  solve(const ElasticModel<3> &model,
        const std::vector<PointForce<3>> &nodal_loads)
  {
    const auto &mesh = scene.body.mesh;
    for (unsigned int e = 0; e < mesh.cells.size(); ++e)
      for (unsigned int n = 0; n < 20; ++n)
        for (unsigned int d = 0; d < 3; ++d)
          unknown(e, n, d);
    dealii::LAPACKFullMatrix<double> matrix(n_unknowns);
    dealii::Vector<double> x(n_unknowns);
    for (const auto &cell :
         model.discretization.dof_handler.active_cell_iterators())
      {
        const unsigned int e = cell->index();
        const auto &k        = model.stiffness(cell);
        for (unsigned int i = 0; i < 60; ++i)
          for (unsigned int j = 0; j < 60; ++j)
            {
              const auto a =
                model.discretization.fe.system_to_component_index(i);
              const auto b =
                model.discretization.fe.system_to_component_index(j);
              const int row    = unknown(e, a.second, a.first);
              const int column = unknown(e, b.second, b.first);
              if (row < 0)
                continue;
              if (column >= 0)
                matrix(row, column) += k(i, j);
              x(row) -= k(i, j) * offset(e, b.second, b.first);
            }
      }
    for (const auto &load : nodal_loads)
      add_load(load, x);
    matrix.set_property(dealii::LAPACKSupport::symmetric);
    matrix.compute_cholesky_factorization();
    matrix.solve(x);

    std::map<std::pair<unsigned int, unsigned int>, dealii::Tensor<1, 3>> u;
    for (unsigned int e = 0; e < mesh.cells.size(); ++e)
      for (unsigned int n = 0; n < 20; ++n)
        for (unsigned int d = 0; d < 3; ++d)
          {
            const int index = unknown(e, n, d);
            u[{e, n}][d]    = (index < 0 ? 0 : x(index)) + offset(e, n, d);
          }
    return u;
  }

private:
  bool
  is_plus(const unsigned int element) const
  {
    return scene.body.mesh.cell_center(element)[c.axis] > 5;
  }

  bool
  is_split(const unsigned int element, const unsigned int node) const
  {
    const auto p = scene.body.mesh.node_position(element, node);
    return std::abs(p[c.axis] - 5) < 1e-6 && c.sign * p[c.along] < front - 1e-6;
  }

  bool
  is_fixed(const unsigned int element, const unsigned int node) const
  {
    const auto p = scene.body.mesh.node_position(element, node);
    return p[2] < 1e-6 || (c.supports == "bottom, top" && p[2] > 10 - 1e-6);
  }

  int
  unknown(const unsigned int element,
          const unsigned int node,
          const unsigned int component)
  {
    if (is_fixed(element, node))
      return -1;
    const bool copy =
      is_plus(element) && is_split(element, node) && component != c.axis;
    const auto inserted = unknowns.emplace(
      std::make_pair(Node(scene.body.node_numbers[element][node], copy),
                     component),
      n_unknowns);
    n_unknowns += inserted.second;
    return inserted.first->second;
  }

  double
  offset(const unsigned int element,
         const unsigned int node,
         const unsigned int component) const
  {
    return component == c.axis && is_plus(element) && is_split(element, node) &&
               !is_fixed(element, node)
             ? scene.blade.thickness
             : 0;
  }

  void
  add_load(const PointForce<3> &load, dealii::Vector<double> &x)
  {
    for (unsigned int e = 0; e < scene.body.mesh.cells.size(); ++e)
      for (unsigned int n = 0; n < 20; ++n)
        if (!is_plus(e) &&
            scene.body.mesh.node_position(e, n).distance(load.point) < 1e-6)
          {
            for (unsigned int d = 0; d < 3; ++d)
              if (unknown(e, n, d) >= 0)
                x(unknown(e, n, d)) += load.force[d];
            return;
          }
    AssertThrow(false, dealii::ExcMessage("There is no node under a load."));
  }

  const Scene<3> &scene;
  const Case &c;
  const double front;
  std::map<std::pair<Node, unsigned int>, int> unknowns;
  int n_unknowns = 0;
};

// Loads 1, 5, 1 at 0, 5, 10 along the edge, by hand: a mid-side row has nodes
// at the ends of elements only, which are there too.
std::vector<PointForce<3>>
loads_on_front(const Case &c, const double front)
{
  const unsigned int edge_axis = 3 - c.axis - c.along;
  std::vector<PointForce<3>> loads(3);
  for (unsigned int i = 0; i < 3; ++i)
    {
      loads[i].point[c.axis]    = 5;
      loads[i].point[c.along]   = c.sign * front;
      loads[i].point[edge_axis] = 5. * i;
      loads[i].force[c.along]   = c.sign * (i == 1 ? 5 : 1);
    }
  return loads;
}

void
compare(const Case &c)
{
  const Parameters parameters("test",
                              {{"Body", "Elements", c.elements, ""},
                               {"Cut", "Surfaces", c.surface, ""},
                               {"Support", "Fixed faces", c.supports, ""},
                               {"Blade", "Direction", c.direction, ""},
                               {"Blade", "Edge loads", c.loads, ""}},
                              Scene<3>::declare);
  const Scene<3> scene(parameters);
  CutBody<3> body(scene, MPI_COMM_WORLD);
  body.begin_cut(scene.cut.cuts[0]);
  body.split_nodes();
  const unsigned int n_rows = body.seam().rows().size();
  std::cout << c.surface << " along " << c.direction << ": " << n_rows
            << " rows" << std::endl;
  for (unsigned int row = 0; row < n_rows; ++row)
    {
      if (row > 0)
        body.release_row(row - 1);
      const auto &discretization = body.model().discretization;
      const auto state           = solve_state(
        body, body.blade_on_row(row), 1, discretization.zero_vector());
      const auto u = discretization.with_ghosts(state.displacement);

      const auto &front_pair =
        body.seam().pairs()[body.seam().rows()[row].front.front()];
      const double front = c.sign * front_pair.position[c.along];
      DirectRoute direct(scene, c, front);
      const auto expected =
        direct.solve(body.model(), loads_on_front(c, front));
      double error = 0, largest = 0;
      for (const auto &cell :
           discretization.dof_handler.active_cell_iterators())
        {
          const auto nodes = discretization.node_indices(cell);
          for (unsigned int n = 0; n < 20; ++n)
            for (unsigned int d = 0; d < 3; ++d)
              {
                const double value =
                  expected.at({discretization.element(cell), n})[d];
                error   = std::max(error, std::abs(u(nodes[n][d]) - value));
                largest = std::max(largest, std::abs(value));
              }
        }
      check_below("  row " + std::to_string(row), error / largest, 1e-9);
    }
}
} // namespace

int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    compare({"2,2,2", "x:1", "0,0,-1", "bottom", "0:1, 5:5, 10:1", 0, 2, -1});
    compare({"2,2,2", "x:1", "0,-1,0", "bottom", "0:1, 5:5, 10:1", 0, 1, -1});
    compare(
      {"2,2,2", "z:1", "-1,0,0", "bottom, top", "0:1, 5:5, 10:1", 2, 0, -1});
  });
}
