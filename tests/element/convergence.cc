// SPDX-License-Identifier: LGPL-2.1-or-later
// The L2 error of an elastic displacement on boxes falls with the third power
// of the mesh size, which is the best that quadratic polynomials can do.

#include <setsudan/element/fe_q_serendipity.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <deal.II/lac/vector.h>

#include <deal.II/numerics/vector_tools.h>

#include <cmath>
#include <vector>

#include "../test_setup.h"
#include "exact_displacements.h"
#include "small_elasticity.h"

using namespace Setsudan;
using namespace dealii;

template <int dim>
double
l2_error(const unsigned int n_cells)
{
  Triangulation<dim> triangulation;
  GridGenerator::subdivided_hyper_cube(triangulation, n_cells);
  const WaveDisplacement<dim> exact;
  SmallElasticity<dim> body(triangulation, FE_Q_Serendipity<dim>(), {1.5, 1.});
  body.solve(exact, wave_force(exact, body.material));

  Vector<double> cell_errors(triangulation.n_active_cells());
  VectorTools::integrate_difference(body.dof_handler,
                                    body.solution,
                                    exact,
                                    cell_errors,
                                    QGauss<dim>(4),
                                    VectorTools::L2_norm);
  return cell_errors.l2_norm();
}


template <int dim>
void
test(const std::vector<unsigned int> &sizes)
{
  double coarser_error = 0.;
  for (unsigned int k = 0; k < sizes.size(); ++k)
    {
      const double error = l2_error<dim>(sizes[k]);
      std::cout << dim << "D, " << sizes[k] << " cells per direction: error "
                << error;
      if (k > 0)
        std::cout << ", rate "
                  << std::round(10. * std::log(coarser_error / error) /
                                std::log(1. * sizes[k] / sizes[k - 1])) /
                       10.;
      std::cout << std::endl;
      coarser_error = error;
    }
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test<2>({4, 8, 16});
    test<3>({3, 5, 7});
  });
}
