// SPDX-License-Identifier: LGPL-2.1-or-later
// Linear elasticity, as little of it as the tests of the element need.
#pragma once

#include <deal.II/base/function.h>
#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>

#include <deal.II/grid/tria.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_solver.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>
#include <deal.II/lac/vector.h>

#include <deal.II/numerics/vector_tools.h>

#include <vector>

namespace Setsudan
{
using namespace dealii;

/** Lame's constants (2D: plane strain). */
struct SmallMaterial
{
  double lambda;
  double mu;
};

/** An elastic body that is held on the part of the boundary with id 0. */
template <int dim>
class SmallElasticity
{
public:
  using VectorType = TrilinosWrappers::MPI::Vector;

  /** Distribute the unknowns of one @p element per component, and constrain
   * the hanging nodes. */
  SmallElasticity(const Triangulation<dim> &triangulation,
                  const FiniteElement<dim> &element,
                  const SmallMaterial &material);

  /** Prescribe the displacement where the boundary has id 0, except at nodes
   * that are constrained already, and solve. */
  void
  solve(const Function<dim> &displacement, const Function<dim> &body_force);

  /** The largest difference of a node's displacement from @p exact. */
  double
  nodal_error(const Function<dim> &exact) const;

  const FESystem<dim> fe;
  const SmallMaterial material;
  const QGauss<dim> quadrature{3};
  DoFHandler<dim> dof_handler;
  IndexSet owned, relevant;
  AffineConstraints<double> constraints;
  VectorType solution;

private:
  void
  setup_matrix();

  void
  assemble(const Function<dim> &body_force);

  /** The stiffness of the cell to which @p scalar_values, the functions of one
   * component, belong. */
  void
  cell_matrix(const FEValues<dim> &scalar_values,
              FullMatrix<double> &stiffness) const;

  /** The nodal forces of @p body_force on that cell. */
  void
  cell_force(const FEValues<dim> &scalar_values,
             const Function<dim> &body_force,
             Vector<double> &force) const;

  TrilinosWrappers::SparseMatrix matrix;
  VectorType rhs;
};


template <int dim>
SmallElasticity<dim>::SmallElasticity(const Triangulation<dim> &triangulation,
                                      const FiniteElement<dim> &element,
                                      const SmallMaterial &material)
  : fe(element, dim)
  , material(material)
  , dof_handler(triangulation)
{
  dof_handler.distribute_dofs(fe);
  owned = dof_handler.locally_owned_dofs();
  DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
  constraints.reinit(relevant);
  DoFTools::make_hanging_node_constraints(dof_handler, constraints);
}


template <int dim>
void
SmallElasticity<dim>::solve(const Function<dim> &displacement,
                            const Function<dim> &body_force)
{
  VectorTools::interpolate_boundary_values(
    dof_handler, 0, displacement, constraints);
  constraints.close();
  setup_matrix();
  assemble(body_force);

  VectorType distributed(owned, MPI_COMM_WORLD);
  SolverControl control;
  TrilinosWrappers::SolverDirect solver(control);
  solver.solve(matrix, distributed, rhs);
  constraints.distribute(distributed);
  solution.reinit(owned, relevant, MPI_COMM_WORLD);
  solution = distributed;
}


template <int dim>
double
SmallElasticity<dim>::nodal_error(const Function<dim> &exact) const
{
  VectorType difference(owned, MPI_COMM_WORLD);
  VectorTools::interpolate(dof_handler, exact, difference);
  VectorType distributed(owned, MPI_COMM_WORLD);
  distributed = solution;
  difference -= distributed;
  return difference.linfty_norm();
}


template <int dim>
void
SmallElasticity<dim>::setup_matrix()
{
  DynamicSparsityPattern pattern(relevant);
  DoFTools::make_sparsity_pattern(dof_handler, pattern, constraints, false);
  SparsityTools::distribute_sparsity_pattern(
    pattern, owned, MPI_COMM_WORLD, relevant);
  matrix.reinit(owned, owned, pattern, MPI_COMM_WORLD);
  rhs.reinit(owned, MPI_COMM_WORLD);
}


template <int dim>
void
SmallElasticity<dim>::assemble(const Function<dim> &body_force)
{
  FEValues<dim> scalar_values(fe.base_element(0),
                              quadrature,
                              update_values | update_gradients |
                                update_quadrature_points | update_JxW_values);
  const unsigned int n = fe.n_dofs_per_cell();
  FullMatrix<double> stiffness(n);
  Vector<double> force(n);
  std::vector<types::global_dof_index> indices(n);
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        scalar_values.reinit(
          static_cast<typename Triangulation<dim>::cell_iterator>(cell));
        cell_matrix(scalar_values, stiffness);
        cell_force(scalar_values, body_force, force);
        cell->get_dof_indices(indices);
        constraints.distribute_local_to_global(
          stiffness, force, indices, matrix, rhs);
      }
  matrix.compress(VectorOperation::add);
  rhs.compress(VectorOperation::add);
}


template <int dim>
void
SmallElasticity<dim>::cell_matrix(const FEValues<dim> &scalar_values,
                                  FullMatrix<double> &stiffness) const
{
  const double lambda            = material.lambda;
  const double mu                = material.mu;
  const unsigned int n_functions = scalar_values.dofs_per_cell;
  for (unsigned int m = 0; m < n_functions; ++m)
    for (unsigned int n = 0; n <= m; ++n)
      {
        Tensor<2, dim> products;
        for (const unsigned int q : scalar_values.quadrature_point_indices())
          products +=
            outer_product(scalar_values.JxW(q) * scalar_values.shape_grad(m, q),
                          scalar_values.shape_grad(n, q));
        for (unsigned int a = 0; a < dim; ++a)
          for (unsigned int b = 0; b < dim; ++b)
            {
              const unsigned int i = fe.component_to_system_index(a, m);
              const unsigned int j = fe.component_to_system_index(b, n);
              stiffness(i, j) = lambda * products[a][b] + mu * products[b][a] +
                                (a == b ? mu * trace(products) : 0.);
              stiffness(j, i) = stiffness(i, j);
            }
      }
}


template <int dim>
void
SmallElasticity<dim>::cell_force(const FEValues<dim> &scalar_values,
                                 const Function<dim> &body_force,
                                 Vector<double> &force) const
{
  force = 0.;
  Vector<double> density(dim);
  for (const unsigned int q : scalar_values.quadrature_point_indices())
    {
      body_force.vector_value(scalar_values.quadrature_point(q), density);
      for (const unsigned int m : scalar_values.dof_indices())
        for (unsigned int a = 0; a < dim; ++a)
          force(fe.component_to_system_index(a, m)) +=
            density(a) * scalar_values.shape_value(m, q) * scalar_values.JxW(q);
    }
}
} // namespace Setsudan
