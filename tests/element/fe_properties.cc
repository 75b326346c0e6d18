// SPDX-License-Identifier: LGPL-2.1-or-later
// What the element tells the library about itself: sizes, constant modes,
// which functions live on which face, support points, and its neighbours.

#include <setsudan/element/fe_q_serendipity.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>
#include <deal.II/base/qprojector.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_system.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

/** Faces on which a function is non-zero although has_support_on_face() says
 * no, or zero although it says yes. */
template <int dim>
unsigned int
n_wrong_supports(const FiniteElement<dim> &fe)
{
  unsigned int n_wrong = 0;
  const QGauss<dim - 1> points(3);
  for (unsigned int face = 0; face < GeometryInfo<dim>::faces_per_cell; ++face)
    {
      const Quadrature<dim> on_face =
        QProjector<dim>::project_to_face(fe.reference_cell(), points, face);
      for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
        {
          double largest = 0.;
          for (const Point<dim> &p : on_face.get_points())
            largest = std::max(largest, std::abs(fe.shape_value(i, p)));
          if ((largest > 1e-12) != fe.has_support_on_face(i, face))
            ++n_wrong;
        }
    }
  return n_wrong;
}


/** The largest distance between a face's support point and the cell's one that
 * has the same unknown, on face 2*dim-1, where coordinate dim-1 is one. */
template <int dim>
double
face_point_error(const FiniteElement<dim> &fe)
{
  const unsigned int face = 2 * dim - 1;
  double error            = 0.;
  for (unsigned int i = 0; i < fe.n_dofs_per_face(face); ++i)
    {
      const Point<dim> on_cell =
        fe.unit_support_point(fe.face_to_cell_index(i, face));
      const Point<dim - 1> on_face = fe.unit_face_support_point(i, face);
      Point<dim> expected;
      for (unsigned int d = 0; d < dim - 1; ++d)
        expected[d] = on_face[d];
      expected[dim - 1] = 1.;
      error             = std::max(error, on_cell.distance(expected));
    }
  return error;
}


template <int dim>
void
test()
{
  const FE_Q_Serendipity<dim> fe;
  std::cout << fe.get_name() << ": " << fe.n_dofs_per_cell() << " per cell, "
            << fe.n_dofs_per_face() << " per face, " << fe.n_dofs_per_line()
            << " inside a line, degree " << fe.degree << ", H1 "
            << fe.conforms(FiniteElementData<dim>::H1) << std::endl;
  std::cout << "wrong supports on faces: " << n_wrong_supports(fe)
            << ", functions on face 0:";
  for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    if (fe.has_support_on_face(i, 0))
      std::cout << ' ' << i;
  std::cout << std::endl;
  check_below("face support points", face_point_error(fe), 0.);

  const FESystem<dim> system(fe, dim);
  const auto modes   = system.get_constant_modes();
  unsigned int n_set = 0;
  for (unsigned int m = 0; m < modes.first.size(0); ++m)
    for (unsigned int i = 0; i < modes.first.size(1); ++i)
      if (modes.first(m, i))
        n_set += system.system_to_component_index(i).first == m ? 1 : 1000;
  std::cout << system.get_name() << ": " << modes.first.size(0)
            << " constant modes, entries " << n_set << std::endl;

  std::cout << "hanging nodes: by hp "
            << system.hp_constraints_are_implemented()
            << ", by the older table " << system.constraints_are_implemented()
            << ", identities " << fe.hp_vertex_dof_identities(fe).size() << ' '
            << fe.hp_line_dof_identities(fe).size() << ' '
            << fe.hp_quad_dof_identities(fe).size() << ", either dominates "
            << (fe.compare_for_domination(fe, 1) ==
                FiniteElementDomination::either_element_can_dominate)
            << std::endl;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test<2>();
    test<3>();
  });
}
