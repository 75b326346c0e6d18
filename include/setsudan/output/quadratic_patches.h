#pragma once

#include <deal.II/base/data_out_base.h>

#include <setsudan/output/shown_stress.h>

#include <utility>

namespace Setsudan
{
/** Values of the cells of this process, by their active_cell_index(), and their
 * name. */
using CellValues = std::pair<std::string, dealii::Vector<float>>;

/**
 * What deal.II's DataOut would show of quadratic elements, displacement, stress
 * and values of cells on cells of 3^dim points, in a fifth of the time: the
 * gradients come from the kernels.
 */
template <int dim>
class QuadraticPatches : public dealii::DataOutInterface<dim>
{
public:
  /** Nothing that is handed over must live longer than the call.
   *
   * @param displacement with ghosts. */
  QuadraticPatches(ElasticModel<dim> &model,
                   const LA::Vector &displacement,
                   const std::vector<CellValues> &cell_values);

protected:
  using Patch = dealii::DataOutBase::Patch<dim, dim>;

  const std::vector<Patch> &
  get_patches() const override;

  std::vector<std::string>
  get_dataset_names() const override;

  std::vector<std::tuple<
    unsigned int,
    unsigned int,
    std::string,
    dealii::DataComponentInterpretation::DataComponentInterpretation>>
  get_nonscalar_data_ranges() const override;

private:
  std::vector<Patch> patches;
  std::vector<std::string> names;
};
} // namespace Setsudan
