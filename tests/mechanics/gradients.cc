// SPDX-License-Identifier: LGPL-2.1-or-later
// Gradients, positions and volumes of StressEvaluator are those of deal.II's
// FEValues with the body's mapping.

#include <setsudan/mechanics/stress/stress_evaluator.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include "many_models.h"

using namespace Setsudan;
using namespace dealii;


template <int dim>
void
compare(const std::string &name, const ElasticModel<dim> &model)
{
  const auto &discretization = model.discretization;
  const LA::Vector u =
    discretization.with_ghosts(random_displacement(discretization));
  const QGauss<dim> points(3);
  StressEvaluator<dim> evaluator(discretization, model.materials, points);
  FEValues<dim> fe_values(discretization.mapping(),
                          discretization.fe,
                          points,
                          update_gradients | update_quadrature_points |
                            update_JxW_values);
  std::vector<Tensor<2, dim>> expected(points.size());
  double error = 0, largest = 0;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        evaluator.reinit(cell, u);
        fe_values.reinit(cell);
        fe_values[FEValuesExtractors::Vector(0)].get_function_gradients(
          u, expected);
        for (unsigned int p = 0; p < points.size(); ++p)
          {
            largest = std::max(largest, expected[p].norm());
            error   = std::max(
              {error,
                 (evaluator.gradient(p) - expected[p]).norm() / largest,
                 evaluator.point(p).distance(fe_values.quadrature_point(p)) /
                   cell->diameter(),
                 std::abs(evaluator.volume(p) / fe_values.JxW(p) - 1)});
          }
      }
  check_below(name, error, 1e-11);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for_each_model(
      [](const std::string &name, auto &model) { compare(name, model); });
  });
}
