// SPDX-License-Identifier: LGPL-2.1-or-later
// A body whose displacement is known: solved with the exact displacement at
// some of its nodes, and compared in the L2 norm.
#pragma once

#include <setsudan/solver/assembled_solver.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <functional>
#include <vector>

#include "../body/small_body.h"

namespace Setsudan
{
/** A displacement and its gradient. */
template <int dim>
struct ExactField
{
  using Point = dealii::Point<dim>;

  std::function<dealii::Tensor<1, dim>(const Point &)> value;
  /** Needed where errors of stress are asked for. */
  std::function<dealii::Tensor<2, dim>(const Point &)> gradient;
};

/** Errors over the norm of the exact field; the stress is that of the
 * displacement formulation. */
struct RelativeErrors
{
  double displacement;
  /** 0 where the field has no gradient. */
  double stress;
};


template <int dim>
struct ExactProblem
{
  using Point = dealii::Point<dim>;

  static void
  declare(dealii::ParameterHandler &handler)
  {
    SupportParameters<dim>::declare(handler);
    MaterialParameters<dim>::declare(handler);
    LoadParameters<dim>::declare(handler);
    SolverParameters::declare(handler);
  }

  ExactProblem(const Body<dim> &the_body,
               const Assignments &assignments,
               const Refinement &refinement = {})
    : body(the_body)
    , parameters(parameters_of(assignments, declare))
    , supports(SupportParameters<dim>(parameters, body), body)
    , material(parameters, body)
    , model(body.mesh,
            refinement,
            body,
            supports,
            LoadParameters<dim>(parameters, body),
            material,
            MPI_COMM_WORLD)
  {
  }

  /** Solve, where nodes that `holds` picks have the exact displacement. */
  RelativeErrors
  errors(const ExactField<dim> &exact,
         const std::function<bool(const Point &)> &holds)
  {
    return compare(exact, solve(exact, holds));
  }

  const Body<dim> body;
  const Parameters parameters;
  const Supports<dim> supports;
  const MaterialParameters<dim> material;
  ElasticModel<dim> model;

private:
  LA::Vector
  solve(const ExactField<dim> &exact,
        const std::function<bool(const Point &)> &holds)
  {
    const auto &discretization = model.discretization;
    dealii::AffineConstraints<double> constraints(discretization.relevant);
    constraints.merge(model.supports);
    LA::Vector prescribed = discretization.zero_vector();
    unsigned int local    = 0;
    for (const auto index : discretization.owned)
      {
        const auto &site = discretization.dof_locations()[local++];
        if (holds(site.position))
          {
            constraints.add_line(index);
            prescribed(index) = exact.value(site.position)[site.component];
          }
      }
    constraints.close();
    return discretization.with_ghosts(
      AssembledSolver<dim>(
        model,
        constraints,
        SolverParameters(parameters),
        choose_assembled(SolverParameters(parameters), size_of(discretization)))
        .solve(model.loads, prescribed, prescribed)
        .displacement);
  }

  RelativeErrors
  compare(const ExactField<dim> &exact, const LA::Vector &u) const
  {
    using namespace dealii;
    const auto &discretization = model.discretization;
    const FEValuesExtractors::Vector displacement(0);
    FEValues<dim> fe_values(discretization.mapping(),
                            discretization.fe,
                            QGauss<dim>(4),
                            update_values | update_gradients |
                              update_quadrature_points | update_JxW_values);
    double difference = 0, norm = 0, stress_difference = 0, stress_norm = 0;
    std::vector<Tensor<1, dim>> values(fe_values.n_quadrature_points);
    std::vector<SymmetricTensor<2, dim>> strains(values.size());
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      {
        fe_values.reinit(cell);
        fe_values[displacement].get_function_values(u, values);
        fe_values[displacement].get_function_symmetric_gradients(u, strains);
        for (unsigned int q = 0; q < values.size(); ++q)
          {
            const auto &point   = fe_values.quadrature_point(q);
            const auto expected = exact.value(point);
            const double JxW    = fe_values.JxW(q);
            difference += (values[q] - expected).norm_square() * JxW;
            norm += expected.norm_square() * JxW;
            if (!exact.gradient)
              continue;
            const Hooke &hooke =
              model.materials.of_element(discretization.element(cell)).at_rest;
            const auto stress = hooke.stress(symmetrize(exact.gradient(point)));
            stress_difference +=
              std::pow((hooke.stress(strains[q]) - stress).norm(), 2) * JxW;
            stress_norm += std::pow(stress.norm(), 2) * JxW;
          }
      }
    return {std::sqrt(difference / norm),
            stress_norm > 0 ? std::sqrt(stress_difference / stress_norm) : 0.};
  }
};
} // namespace Setsudan
