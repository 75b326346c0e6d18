// SPDX-License-Identifier: LGPL-2.1-or-later
// A frame shows at the nodes of all cells where they are, and the displacement
// and the stress there.

#include <setsudan/mechanics/stress/stress_evaluator.h>
#include <setsudan/output/frames/frame_content.h>

#include "../mechanics/many_models.h"

using namespace Setsudan;


/** The largest difference of two vectors' components so far, and the largest
 * component. */
struct Difference
{
  double difference = 0, largest = 0;

  void
  add(const double shown, const double expected)
  {
    difference = std::max(difference, std::abs(shown - expected));
    largest    = std::max(largest, std::abs(expected));
  }

  void
  check(const std::string &name) const
  {
    // Frames have the digits of single precision.
    check_below_on_all(
      name, difference / Utilities::MPI::max(largest, MPI_COMM_WORLD), 1e-6);
  }
};


template <int dim>
void
compare(const std::string &name, ElasticModel<dim> &model)
{
  const auto &discretization = model.discretization;
  const unsigned int n_cells = discretization.triangulation.n_active_cells();
  const LA::Vector u =
    discretization.with_ghosts(random_displacement(discretization));
  ElementLabels labels;
  Body<dim> body;
  body.node_numbers.resize(n_cells);
  for (unsigned int e = 0; e < n_cells; ++e)
    {
      labels.side.push_back(e % 3 - 1);
      labels.piece.push_back(e);
      for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
        body.node_numbers[e][node] = 100 * e + node;
    }
  // The front is a node of this process.
  FrameFacts facts;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned() && facts.front.empty())
      facts.front = {discretization.node_indices(cell)[0][0]};
  const VtuGrid shown = frame_content(body, model, u, labels, {}, facts);
  const auto field    = [&](const unsigned int f) {
    return std::get<std::vector<float>>(shown.point_data[f].values);
  };
  const auto numbers = [](const VtuArray &array) {
    return std::get<std::vector<std::int32_t>>(array.values);
  };
  const auto points        = std::get<std::vector<float>>(shown.points);
  const auto displacements = field(0), stresses = field(1), strains = field(2),
             principal = field(3), shears = field(4), mises = field(5);
  const auto nodes = numbers(shown.point_data[6]);
  const auto front = numbers(shown.point_data[7]);

  // The points of a cell, x fastest, as many in each direction.
  const unsigned int n_1d = discretization.type == ElementType::linear ? 2 : 3;
  constexpr unsigned int order[6][2] = {
    {0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}};
  StressEvaluator<dim> recovery(
    discretization, model.materials, node_points(discretization));
  Difference position, displacement, stress, strain, number;
  unsigned int first = 0, cell_number = 0;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        recovery.reinit(cell, u);
        const auto positions = discretization.node_positions(cell);
        const auto indices   = discretization.node_indices(cell);
        for (unsigned int node = 0; node < positions.size(); ++node)
          {
            unsigned int point = 0;
            for (int c = dim - 1; c >= 0; --c)
              point = point * n_1d +
                      std::lround(discretization.nodes()[node][c] * (n_1d - 1));
            point += first;
            const auto expected = recovery.stress(node);
            for (unsigned int c = 0; c < dim; ++c)
              {
                position.add(points[3 * point + c], positions[node][c]);
                displacement.add(displacements[3 * point + c],
                                 u(indices[node][c]));
              }
            for (unsigned int i = 0; i < 6; ++i)
              {
                stress.add(stresses[6 * point + i],
                           expected[order[i][0]][order[i][1]]);
                if (order[i][0] < dim && order[i][1] < dim)
                  strain.add(strains[6 * point + i],
                             recovery.strain(node)[order[i][0]][order[i][1]]);
                else
                  strain.add(strains[6 * point + i], 0);
              }
            stress.add(shears[point], maximum_shear(expected));
            stress.add(principal[3 * point] - principal[3 * point + 2],
                       2 * maximum_shear(expected));
            stress.add(mises[point],
                       std::sqrt(1.5) * deviator(expected).norm());
            number.add(nodes[point],
                       node < n_element_nodes<dim>
                         ? 100. * cell->active_cell_index() + node
                         : -1);
            number.add(front[point], indices[node][0] == facts.front[0]);
          }
        number.add(numbers(shown.cell_data[2])[cell_number++],
                   cell->active_cell_index());
        first += shown.n_points_of_cell;
      }
  position.check(name + ", position");
  displacement.check(name + ", displacement");
  stress.check(name + ", stress");
  strain.check(name + ", strain");
  if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
    number.check(name + ", numbers");
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for_each_model(
      [](const std::string &name, auto &model) { compare(name, model); });
  });
}
