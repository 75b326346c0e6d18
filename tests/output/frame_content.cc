// A frame shows at the nodes of all cells where they are, and the displacement
// and the stress there.

#include <setsudan/elasticity/strain_recovery.h>
#include <setsudan/output/frame_content.h>

#include "../elasticity/many_models.h"

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
  for (unsigned int e = 0; e < n_cells; ++e)
    {
      labels.side.push_back(e % 3 - 1);
      labels.piece.push_back(e);
    }
  const VtuCells shown = frame_content(model, u, labels, {});

  // The points of a cell, x fastest, as many in each direction.
  const unsigned int n_1d = discretization.type == ElementType::linear ? 2 : 3;
  StrainRecovery<dim> recovery(
    discretization, model.materials, node_points(discretization));
  Difference position, displacement, stress, piece;
  unsigned int first = 0;
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
                position.add(shown.points[3 * point + c], positions[node][c]);
                displacement.add(shown.data[0].values[3 * point + c],
                                 u(indices[node][c]));
                for (unsigned int d = 0; d < dim; ++d)
                  stress.add(shown.data[1].values[9 * point + 3 * c + d],
                             expected[c][d]);
              }
            stress.add(shown.data[2].values[point], maximum_shear(expected));
            stress.add(shown.data[3].values[point], expected[2][2]);
            piece.add(shown.data[5].values[point], cell->active_cell_index());
          }
        first += shown.order.size();
      }
  position.check(name + ", position");
  displacement.check(name + ", displacement");
  stress.check(name + ", stress");
  if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
    piece.check(name + ", piece");
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for_each_model(
      [](const std::string &name, auto &model) { compare(name, model); });
  });
}
