#pragma once

#include <setsudan/elasticity/elastic_model.h>
#include <setsudan/elasticity/strain_recovery.h>

#include <array>
#include <vector>

namespace Setsudan
{
/**
 * A continuous stress field that is nearer to the exact one than the elements'
 * own: the stress at the 2^dim Gauss points of each cell, where it is most
 * accurate, is extrapolated to the cell's nodes, averaged there over the cells
 * of one material that meet, and interpolated by the shape functions (Hinton
 * and Campbell 1974, International Journal for Numerical Methods in Engineering
 * 8, 461-480; as an estimate of the error Zienkiewicz and Zhu 1987, ibid. 24,
 * 337-357).
 *
 * The two sides of a cut are averaged each for itself. Components are held in
 * vectors of the displacement's kind, dim in each.
 */
template <int dim>
class RecoveredStress
{
public:
  using Cell = typename Discretization<dim>::Cell;

  /** @param displacement with ghosts. */
  RecoveredStress(const ElasticModel<dim> &model,
                  const LA::Vector &displacement);

  /** The stress at the points of `fe_values`, which has been set to `cell`. */
  std::vector<dealii::SymmetricTensor<2, 3>>
  evaluate(const Cell &cell, const dealii::FEValues<dim> &fe_values) const;

private:
  /** Vectors that are needed for 6 components in space, 4 in the plane. */
  static constexpr unsigned int n_vectors = 2;

  void
  add_cells_of_material(const unsigned int material,
                        const LA::Vector &displacement);

  const ElasticModel<dim> &model;
  /** With ghosts, for each material. */
  std::vector<std::array<LA::Vector, n_vectors>> fields;
};

/** The stress at all points of a cell that `recovery` was set to: the recovered
 * one, or the element's own where there is none. */
template <int dim>
std::vector<dealii::SymmetricTensor<2, 3>>
stresses_of_cell(const typename Discretization<dim>::Cell &cell,
                 const StrainRecovery<dim> &recovery,
                 const RecoveredStress<dim> *recovered);
} // namespace Setsudan
