#include <deal.II/base/mpi.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <setsudan/output/frames.h>
#include <setsudan/output/quadratic_patches.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The stress for deal.II's DataOut. */
template <int dim>
class StressPostprocessor : public DataPostprocessor<dim>
{
public:
  StressPostprocessor(const ElasticModel<dim> &model,
                      const LA::Vector &displacement)
    : stress(model, displacement)
  {
  }

  void
  evaluate_vector_field(
    const DataPostprocessorInputs::Vector<dim> &inputs,
    std::vector<dealii::Vector<double>> &values) const override
  {
    const auto cell = inputs.template get_cell<dim>();
    for (unsigned int p = 0; p < values.size(); ++p)
      {
        Tensor<2, dim> gradient;
        for (unsigned int d = 0; d < dim; ++d)
          gradient[d] = inputs.solution_gradients[p][d];
        stress.evaluate(cell, inputs.evaluation_points[p], gradient, values[p]);
      }
  }

  std::vector<std::string>
  get_names() const override
  {
    return stress.names();
  }

  std::vector<DataComponentInterpretation::DataComponentInterpretation>
  get_data_component_interpretation() const override
  {
    std::vector<DataComponentInterpretation::DataComponentInterpretation>
      interpretation(dim * dim,
                     DataComponentInterpretation::component_is_part_of_tensor);
    interpretation.resize(stress.n_values,
                          DataComponentInterpretation::component_is_scalar);
    return interpretation;
  }

  UpdateFlags
  get_needed_update_flags() const override
  {
    return update_gradients | update_quadrature_points;
  }

private:
  const ShownStress<dim> stress;
};


/** The values of a scene's elements, for its cells. */
template <int dim>
std::vector<CellValues>
cell_values(const ElasticModel<dim> &model,
            const ElementLabels &labels,
            const dealii::Vector<double> &error_squares)
{
  const auto &discretization = model.discretization;
  std::vector<CellValues> result;
  const auto add = [&](const std::string &name, const auto &value_of_element) {
    dealii::Vector<float> data(discretization.triangulation.n_active_cells());
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        data(cell->active_cell_index()) =
          value_of_element(discretization.element(cell));
    result.emplace_back(name, std::move(data));
  };
  add("side", [&](const unsigned int e) { return labels.side[e]; });
  add("piece", [&](const unsigned int e) { return labels.piece[e]; });
  add("material",
      [&](const unsigned int e) { return model.materials.number(e); });
  if (error_squares.size() == 0)
    return result;
  dealii::Vector<float> error(error_squares.size());
  std::transform(error_squares.begin(),
                 error_squares.end(),
                 error.begin(),
                 [](const double square) { return std::sqrt(square); });
  result.emplace_back("energy_error", std::move(error));
  return result;
}


/** What deal.II makes of linear elements, for which there are no kernels. */
template <int dim>
std::unique_ptr<DataOutInterface<dim>>
linear_patches(const ElasticModel<dim> &model,
               const LA::Vector &displacement,
               const std::vector<CellValues> &of_cells)
{
  const StressPostprocessor<dim> stress(model, displacement);
  auto data_out = std::make_unique<DataOut<dim>>();
  data_out->attach_dof_handler(model.discretization.dof_handler);
  data_out->add_data_vector(
    displacement,
    std::vector<std::string>(dim, "displacement"),
    DataOut<dim>::type_dof_data,
    std::vector<DataComponentInterpretation::DataComponentInterpretation>(
      dim, DataComponentInterpretation::component_is_part_of_vector));
  data_out->add_data_vector(displacement, stress);
  for (const auto &[name, values] : of_cells)
    data_out->add_data_vector(values, name, DataOut<dim>::type_cell_data);
  data_out->build_patches(
    model.discretization.mapping(), 1, DataOut<dim>::curved_inner_cells);
  data_out->clear_input_data_references();
  return data_out;
}


/** What a frame shows, without the body that it was taken from. */
template <int dim>
class Frame
{
public:
  Frame(ElasticModel<dim> &model,
        const LA::Vector &displacement,
        const std::vector<CellValues> &of_cells)
  {
    if (model.discretization.type == ElementType::linear)
      content = linear_patches(model, displacement, of_cells);
    else
      content =
        std::make_unique<QuadraticPatches<dim>>(model, displacement, of_cells);
    DataOutBase::VtkFlags flags;
    flags.write_higher_order_cells = true;
    // Frames that are a tenth smaller would take many times as long.
    flags.compression_level = DataOutBase::VtkFlags::best_speed;
    content->set_flags(flags);
  }

  /** @param base the files' names up to the ending.
   * @param rank  of this process, and how many there are. */
  void
  write(const OutputDirectory &directory,
        const std::string &base,
        const unsigned int rank,
        const unsigned int n_ranks) const
  {
    const auto name_of_rank = [&](const unsigned int r) {
      return n_ranks == 1 ? base + ".vtu"
                          : base + "." + std::to_string(r) + ".vtu";
    };
    directory.write(name_of_rank(rank),
                    [&](std::ostream &out) { content->write_vtu(out); });
    if (rank > 0 || n_ranks == 1)
      return;
    std::vector<std::string> names;
    for (unsigned int r = 0; r < n_ranks; ++r)
      names.push_back(name_of_rank(r));
    directory.write(base + ".pvtu", [&](std::ostream &out) {
      content->write_pvtu_record(out, names);
    });
  }

private:
  std::unique_ptr<DataOutInterface<dim>> content;
};
} // namespace


template <int dim>
FrameWriter<dim>::FrameWriter(const OutputDirectory &directory)
  : directory(directory)
{
}



template <int dim>
void
FrameWriter<dim>::write(const unsigned int frame,
                        ElasticModel<dim> &model,
                        const LA::Vector &displacement,
                        const ElementLabels &labels,
                        const dealii::Vector<double> &error_squares)
{
  const MPI_Comm communicator = model.discretization.communicator;
  const unsigned int rank     = Utilities::MPI::this_mpi_process(communicator);
  const unsigned int n_ranks  = Utilities::MPI::n_mpi_processes(communicator);
  const std::string base      = "frame_" + Utilities::to_string(frame, 4);
  const auto content          = std::make_shared<const Frame<dim>>(
    model, displacement, cell_values(model, labels, error_squares));
  finish();
  sequence.emplace_back(frame, base + (n_ranks == 1 ? ".vtu" : ".pvtu"));
  // MPI is not called from there.
  pending = std::async(std::launch::async,
                       [this, content, base, rank, n_ranks, shown = sequence] {
                         content->write(directory, base, rank, n_ranks);
                         if (rank == 0)
                           directory.write("cut.pvd", [&](std::ostream &out) {
                             DataOutBase::write_pvd_record(out, shown);
                           });
                       });
}



template <int dim>
void
FrameWriter<dim>::finish()
{
  if (pending.valid())
    pending.get();
}



template class FrameWriter<2>;
template class FrameWriter<3>;
} // namespace Setsudan
