#include <deal.II/base/mpi.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <setsudan/elasticity/dilatation.h>
#include <setsudan/output/frames.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <memory>
#include <ostream>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Stress and maximum shear of each cell, for ParaView. */
template <int dim>
class StressPostprocessor : public DataPostprocessor<dim>
{
public:
  StressPostprocessor(const ElasticModel<dim> &model,
                      const LA::Vector &displacement)
    : model(model)
  {
    if (!model.materials.any_is_mixed())
      return;
    const auto &discretization = model.discretization;
    dilatations.resize(discretization.triangulation.n_active_cells());
    Dilatation<dim> dilatation(discretization);
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        dilatations[cell->active_cell_index()] = dilatation(cell, displacement);
  }

  void
  evaluate_vector_field(
    const DataPostprocessorInputs::Vector<dim> &inputs,
    std::vector<dealii::Vector<double>> &values) const override
  {
    const auto cell = inputs.template get_cell<dim>();
    const Material &material =
      model.materials.of_element(model.discretization.element(cell));
    for (unsigned int p = 0; p < values.size(); ++p)
      {
        Tensor<2, dim> gradient;
        for (unsigned int d = 0; d < dim; ++d)
          gradient[d] = inputs.solution_gradients[p][d];
        const auto strain = symmetrize(gradient);
        const auto stress = material.hooke.stress(
          strain,
          material.is_mixed ? dilatations[cell->active_cell_index()](
                                inputs.evaluation_points[p])
                            : trace(strain));
        unsigned int n = 0;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            values[p](n++) = stress[i][j];
        values[p](n++) = maximum_shear(stress);
        values[p](n)   = stress[2][2];
      }
  }

  std::vector<std::string>
  get_names() const override
  {
    std::vector<std::string> names(dim * dim, "stress");
    names.push_back("maximum_shear");
    names.push_back("stress_zz");
    return names;
  }

  std::vector<DataComponentInterpretation::DataComponentInterpretation>
  get_data_component_interpretation() const override
  {
    std::vector<DataComponentInterpretation::DataComponentInterpretation>
      interpretation(dim * dim,
                     DataComponentInterpretation::component_is_part_of_tensor);
    interpretation.resize(dim * dim + 2,
                          DataComponentInterpretation::component_is_scalar);
    return interpretation;
  }

  UpdateFlags
  get_needed_update_flags() const override
  {
    return update_gradients | update_quadrature_points;
  }

private:
  const ElasticModel<dim> &model;
  /** Of the cells of this process, where a material is mixed. */
  std::vector<LinearFunction<dim>> dilatations;
};


template <int dim>
dealii::Vector<float>
cell_data(const Discretization<dim> &discretization,
          const std::function<float(unsigned int)> &value_of_element)
{
  dealii::Vector<float> data(discretization.triangulation.n_active_cells());
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      data(cell->active_cell_index()) =
        value_of_element(discretization.element(cell));
  return data;
}


/** What a frame shows, without the body that it was taken from. */
template <int dim>
class Frame
{
public:
  Frame(const ElasticModel<dim> &model,
        const LA::Vector &displacement,
        const ElementLabels &labels,
        const dealii::Vector<double> &error_squares)
    : stress(model, displacement)
  {
    add_displacement(model.discretization, displacement);
    add_cell_data(model, labels, error_squares);
    DataOutBase::VtkFlags flags;
    flags.write_higher_order_cells = true;
    // Frames that are a tenth smaller would take many times as long.
    flags.compression_level = DataOutBase::VtkFlags::best_speed;
    data_out.set_flags(flags);
    data_out.build_patches(model.discretization.mapping(),
                           model.discretization.type == ElementType::linear ? 1
                                                                            : 2,
                           DataOut<dim>::curved_inner_cells);
    data_out.clear_input_data_references();
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
                    [&](std::ostream &out) { data_out.write_vtu(out); });
    if (rank > 0 || n_ranks == 1)
      return;
    std::vector<std::string> names;
    for (unsigned int r = 0; r < n_ranks; ++r)
      names.push_back(name_of_rank(r));
    directory.write(base + ".pvtu", [&](std::ostream &out) {
      data_out.write_pvtu_record(out, names);
    });
  }

private:
  void
  add_displacement(const Discretization<dim> &discretization,
                   const LA::Vector &displacement)
  {
    data_out.attach_dof_handler(discretization.dof_handler);
    data_out.add_data_vector(
      displacement,
      std::vector<std::string>(dim, "displacement"),
      DataOut<dim>::type_dof_data,
      std::vector<DataComponentInterpretation::DataComponentInterpretation>(
        dim, DataComponentInterpretation::component_is_part_of_vector));
    data_out.add_data_vector(displacement, stress);
  }

  void
  add_cell_data(const ElasticModel<dim> &model,
                const ElementLabels &labels,
                const dealii::Vector<double> &error_squares)
  {
    const auto add = [&](const std::string &name, const auto &value) {
      cell_values.push_back(cell_data<dim>(model.discretization, value));
      data_out.add_data_vector(
        cell_values.back(), name, DataOut<dim>::type_cell_data);
    };
    add("side", [&](const unsigned int e) { return labels.side[e]; });
    add("piece", [&](const unsigned int e) { return labels.piece[e]; });
    add("material",
        [&](const unsigned int e) { return model.materials.number(e); });
    if (error_squares.size() == 0)
      return;
    dealii::Vector<float> error(error_squares.size());
    std::transform(error_squares.begin(),
                   error_squares.end(),
                   error.begin(),
                   [](const double square) { return std::sqrt(square); });
    cell_values.push_back(std::move(error));
    data_out.add_data_vector(
      cell_values.back(), "energy_error", DataOut<dim>::type_cell_data);
  }

  StressPostprocessor<dim> stress;
  std::list<dealii::Vector<float>> cell_values;
  DataOut<dim> data_out;
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
                        const ElasticModel<dim> &model,
                        const LA::Vector &displacement,
                        const ElementLabels &labels,
                        const dealii::Vector<double> &error_squares)
{
  const MPI_Comm communicator = model.discretization.communicator;
  const unsigned int rank     = Utilities::MPI::this_mpi_process(communicator);
  const unsigned int n_ranks  = Utilities::MPI::n_mpi_processes(communicator);
  const std::string base      = "frame_" + Utilities::to_string(frame, 4);
  const auto content          = std::make_shared<const Frame<dim>>(
    model, displacement, labels, error_squares);
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
