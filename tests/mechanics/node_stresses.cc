// The stress at single nodes is what StrainRecovery has at all of them.

#include <setsudan/mechanics/stress/node_stresses.h>
#include <setsudan/mechanics/stress/strain_recovery.h>

#include "many_models.h"

using namespace Setsudan;


template <int dim>
void
compare(const std::string &name, ElasticModel<dim> &model)
{
  const auto &discretization = model.discretization;
  const LA::Vector u =
    discretization.with_ghosts(random_displacement(discretization));
  const NodeStresses<dim> at_nodes(discretization, model.materials);
  StrainRecovery<dim> recovery(
    discretization, model.materials, node_points(discretization));
  const std::vector<unsigned int> nodes{
    1, static_cast<unsigned int>(discretization.nodes().size()) - 1};
  double error = 0, largest = 0;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        recovery.reinit(cell, u);
        const auto stresses = at_nodes(cell, nodes, u);
        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            const auto expected = recovery.stress(nodes[i]);
            error   = std::max(error, (stresses[i] - expected).norm());
            largest = std::max(largest, expected.norm());
          }
      }
  check_below(name, error / largest, 1e-11);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for_each_model(
      [](const std::string &name, auto &model) { compare(name, model); });
  });
}
