// SPDX-License-Identifier: LGPL-2.1-or-later
// FE_Q(2), constrained to the serendipity space, gives the same displacements:
// its nodes inside of faces and cells get the values that the serendipity
// functions of the cell take there.

#include <setsudan/element/fe_q_serendipity.h>

#include <deal.II/base/function.h>
#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../test_setup.h"
#include "small_elasticity.h"

using namespace Setsudan;
using namespace dealii;

/** Constrain an elastic body of FE_Q(2) to the serendipity space. */
template <int dim>
void
constrain_inner_nodes(SmallElasticity<dim> &body)
{
  const FE_Q_Serendipity<dim> serendipity;
  const FESystem<dim> &fe = body.fe;
  std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
  for (const auto &cell : body.dof_handler.active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      // Vertices and lines come first, in the same order in both elements.
      for (unsigned int i = dim * serendipity.n_dofs_per_cell();
           i < dofs.size();
           ++i)
        {
          if (body.constraints.is_constrained(dofs[i]))
            continue;
          const unsigned int a = fe.system_to_component_index(i).first;
          body.constraints.add_line(dofs[i]);
          for (unsigned int m = 0; m < serendipity.n_dofs_per_cell(); ++m)
            body.constraints.add_entry(
              dofs[i],
              dofs[fe.component_to_system_index(a, m)],
              serendipity.shape_value(m, fe.unit_support_point(i)));
        }
    }
}


/** The largest difference of the displacements at the common nodes. */
template <int dim>
double
difference(const SmallElasticity<dim> &a, const SmallElasticity<dim> &b)
{
  std::vector<types::global_dof_index> a_dofs(a.fe.n_dofs_per_cell());
  std::vector<types::global_dof_index> b_dofs(b.fe.n_dofs_per_cell());
  double result = 0.;
  for (const auto &cell : a.dof_handler.active_cell_iterators())
    {
      cell->get_dof_indices(a_dofs);
      typename DoFHandler<dim>::active_cell_iterator(&cell->get_triangulation(),
                                                     cell->level(),
                                                     cell->index(),
                                                     &b.dof_handler)
        ->get_dof_indices(b_dofs);
      for (unsigned int i = 0; i < a_dofs.size(); ++i)
        result = std::max(
          result, std::abs(a.solution(a_dofs[i]) - b.solution(b_dofs[i])));
    }
  return result;
}


template <int dim>
void
test(const std::string &name, const Function<dim> &body_force)
{
  Triangulation<dim> triangulation;
  std::vector<unsigned int> n_cells(dim, 2);
  n_cells[0] = 3;
  Point<dim> far;
  for (unsigned int d = 0; d < dim; ++d)
    far[d] = 1.5 - 0.25 * d;
  // The body is held at the left (boundary 0) and free elsewhere.
  GridGenerator::subdivided_hyper_rectangle(
    triangulation, n_cells, Point<dim>(), far, true);

  const SmallMaterial material{1.5, 1.};
  SmallElasticity<dim> ours(triangulation, FE_Q_Serendipity<dim>(), material);
  SmallElasticity<dim> reference(triangulation, FE_Q<dim>(2), material);
  constrain_inner_nodes(reference);
  const Functions::ZeroFunction<dim> zero(dim);
  ours.solve(zero, body_force);
  reference.solve(zero, body_force);

  const std::string label = std::to_string(dim) + "D " + name;
  std::cout << label << ": largest displacement " << ours.solution.linfty_norm()
            << std::endl;
  check_below(label + ", difference", difference(ours, reference), 1e-10);
}


template <int dim>
class LinearForce : public Function<dim>
{
public:
  LinearForce()
    : Function<dim>(dim)
  {
  }

  double
  value(const Point<dim> &p, const unsigned int component) const override
  {
    return 0.1 + p[component] - 0.5 * p[(component + 1) % dim];
  }
};


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test<2>("weight",
            Functions::ConstantFunction<2>(std::vector<double>{0., -1.}));
    test<2>("linear body force", LinearForce<2>());
    test<3>("weight",
            Functions::ConstantFunction<3>(std::vector<double>{0., 0., -1.}));
    test<3>("linear body force", LinearForce<3>());
  });
}
