#pragma once

#include <setsudan/elasticity/dilatation.h>
#include <setsudan/elasticity/elastic_model.h>

#include <string>
#include <vector>

namespace Setsudan
{
/** What a frame shows of the stress: its components, the maximum shear, and the
 * normal stress that a plane body has across its plane. */
template <int dim>
class ShownStress
{
public:
  using Cell = typename Discretization<dim>::Cell;

  static constexpr unsigned int n_values = dim * dim + 2;

  /** @param displacement with ghosts. */
  ShownStress(const ElasticModel<dim> &model, const LA::Vector &displacement);

  /** The names of the values; those of one tensor are the same. */
  static std::vector<std::string>
  names();

  /** @param values n_values of them. */
  template <typename Values>
  void
  evaluate(const Cell &cell,
           const dealii::Point<dim> &point,
           const dealii::Tensor<2, dim> &gradient,
           Values &&values) const
  {
    const auto stress = stress_at(cell, point, gradient);
    unsigned int n    = 0;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        values(n++) = stress[i][j];
    values(n++) = shear(stress);
    values(n)   = stress[2][2];
  }

private:
  dealii::SymmetricTensor<2, 3>
  stress_at(const Cell &cell,
            const dealii::Point<dim> &point,
            const dealii::Tensor<2, dim> &gradient) const;

  /** The maximum shear up to the digits that a frame has, in a fraction of the
   * time that maximum_shear() takes. */
  static double
  shear(const dealii::SymmetricTensor<2, 3> &stress);

  const ElasticModel<dim> &model;
  /** Of the cells of this process, where a material is mixed. */
  std::vector<LinearFunction<dim>> dilatations;
};
} // namespace Setsudan
