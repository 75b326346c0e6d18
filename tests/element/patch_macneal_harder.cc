// SPDX-License-Identifier: LGPL-2.1-or-later
// The patch test for solids of MacNeal and Harder, A proposed standard set of
// problems to test finite element accuracy, Finite Elements in Analysis and
// Design 1, 1985: a unit cube of seven distorted hexahedra under a linear
// displacement of its boundary must have the stresses 2000 and 400 everywhere.

#include <setsudan/element/fe_q_serendipity.h>

#include <deal.II/base/function.h>
#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/fe_values_extractors.h>

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../test_setup.h"
#include "small_elasticity.h"

using namespace Setsudan;
using namespace dealii;

/** The inner cube, and a cell between each of its faces and the outer cube. */
void
make_mesh(Triangulation<3> &triangulation)
{
  std::vector<Point<3>> vertices;
  for (unsigned int v = 0; v < 8; ++v)
    vertices.push_back(GeometryInfo<3>::unit_cell_vertex(v));
  vertices.insert(vertices.end(),
                  {{.249, .342, .192},
                   {.826, .288, .288},
                   {.273, .750, .230},
                   {.850, .649, .263},
                   {.320, .186, .643},
                   {.677, .305, .683},
                   {.165, .745, .702},
                   {.788, .693, .644}});
  std::vector<CellData<3>> cells(7, CellData<3>(8));
  for (unsigned int v = 0; v < 8; ++v)
    cells[6].vertices[v] = 8 + v;
  for (unsigned int face = 0; face < 6; ++face)
    for (unsigned int v = 0; v < 8; ++v)
      {
        // Vertex v of the cell lies on the outer cube if it lies on this face
        // of the cell, and at that corner, or at the inner one opposite.
        const unsigned int direction = 1U << (face / 2);
        const unsigned int side      = (face % 2) * direction;
        const unsigned int corner    = (v & ~direction) | side;
        const bool is_outer          = (v & direction) == side;
        cells[face].vertices[v]      = is_outer ? corner : 8 + corner;
      }
  triangulation.create_triangulation(vertices, cells, SubCellData());
}


class BoundaryDisplacement : public Function<3>
{
public:
  BoundaryDisplacement()
    : Function<3>(3)
  {
  }

  double
  value(const Point<3> &p, const unsigned int component) const override
  {
    return 1e-3 * (p[0] + p[1] + p[2] + p[component]) / 2.;
  }
};


/** The largest error of a stress at the Gauss points. */
double
stress_error(const SmallElasticity<3> &body)
{
  FEValues<3> fe_values(body.fe, body.quadrature, update_gradients);
  const FEValuesExtractors::Vector displacement(0);
  SymmetricTensor<2, 3> exact;
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int b = 0; b <= a; ++b)
      exact[a][b] = a == b ? 2000. : 400.;

  std::vector<SymmetricTensor<2, 3>> strains(body.quadrature.size());
  double error = 0.;
  for (const auto &cell : body.dof_handler.active_cell_iterators())
    {
      fe_values.reinit(cell);
      fe_values[displacement].get_function_symmetric_gradients(body.solution,
                                                               strains);
      for (const auto &strain : strains)
        {
          const SymmetricTensor<2, 3> stress =
            2. * body.material.mu * strain +
            body.material.lambda * trace(strain) * unit_symmetric_tensor<3>();
          error = std::max(error, (stress - exact).norm());
        }
    }
  return error;
}


void
test(const std::string &name, const Triangulation<3> &triangulation)
{
  const double e = 1e6, nu = 0.25;
  SmallElasticity<3> body(
    triangulation,
    FE_Q_Serendipity<3>(),
    {e * nu / (1. + nu) / (1. - 2. * nu), e / 2. / (1. + nu)});
  const BoundaryDisplacement displacement;
  body.solve(displacement, Functions::ZeroFunction<3>(3));

  std::cout << name << ": " << triangulation.n_active_cells() << " cells, "
            << body.dof_handler.n_dofs() << " unknowns" << std::endl;
  check_below("displacement, relative to 1e-3",
              body.nodal_error(displacement) / 1e-3,
              1e-9);
  check_below("stress, relative to 2000", stress_error(body) / 2000., 1e-9);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    Triangulation<3> triangulation;
    make_mesh(triangulation);
    test("seven cells", triangulation);

    // Hanging nodes on faces that are neither plane nor in standard position.
    triangulation.last_active()->set_refine_flag();
    triangulation.execute_coarsening_and_refinement();
    test("the inner one refined", triangulation);
  });
}
