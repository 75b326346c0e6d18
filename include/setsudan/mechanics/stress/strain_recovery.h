#pragma once

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>

#include <setsudan/material/material_parameters.h>
#include <setsudan/mechanics/dilatation.h>

#include <memory>
#include <vector>

namespace Setsudan
{
/** Where in a cell stress is asked for: its nodes, or its Gauss points. */
template <int dim>
dealii::Quadrature<dim>
node_points(const Discretization<dim> &discretization);

template <int dim>
dealii::Quadrature<dim>
gauss_points(const Discretization<dim> &discretization);

/**
 * Displacement gradients of a cell, and the strain and stress that follow
 * (equations 6 and 7 of Kakefuda et al. 1996), evaluated directly where they
 * are asked for: no extrapolation, no averaging.
 */
template <int dim>
class StrainRecovery
{
public:
  using Cell = typename Discretization<dim>::Cell;

  /** @param discretization and materials must live as long.
   * @param flags what else is asked for: positions and volumes of points. */
  StrainRecovery(const Discretization<dim> &discretization,
                 const MaterialParameters<dim> &materials,
                 const dealii::Quadrature<dim> &points,
                 const dealii::UpdateFlags flags = dealii::update_default);

  /** Evaluate a displacement (with ghosts) on a cell. */
  void
  reinit(const Cell &cell, const LA::Vector &displacement);

  unsigned int
  n_points() const;

  /** The element's functions at the points of the present cell, in so far as
   * they were asked for. */
  const dealii::FEValues<dim> &
  values() const;

  /** The position of a point, where update_quadrature_points was asked for. */
  const dealii::Point<dim> &
  point(const unsigned int point) const;

  /** The volume that a point of a quadrature rule stands for, where
   * update_JxW_values was asked for. */
  double
  volume(const unsigned int point) const;

  const dealii::Tensor<2, dim> &
  gradient(const unsigned int point) const;

  dealii::SymmetricTensor<2, dim>
  strain(const unsigned int point) const;

  dealii::SymmetricTensor<2, 3>
  stress(const unsigned int point) const;

private:
  const Discretization<dim> &discretization;
  const MaterialParameters<dim> &materials;
  dealii::FEValues<dim> fe_values;
  std::vector<dealii::Tensor<2, dim>> gradients;
  const Material *material = nullptr;
  /** Only where a material needs it. */
  std::unique_ptr<Dilatation<dim>> dilatation;
  LinearFunction<dim> dilatation_of_cell;
};
} // namespace Setsudan
