#include <deal.II/base/quadrature_lib.h>

#include <setsudan/elasticity/grid_gradients.h>
#include <setsudan/output/quadratic_patches.h>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The functions of an element at a point that differ from 0 there. */
using Functions = std::vector<std::pair<unsigned int, double>>;

/** The functions at the points of a patch, x fastest. */
template <int dim>
std::vector<Functions>
functions_on_grid(const FiniteElement<dim> &element)
{
  std::vector<Functions> functions;
  for (const auto &point : QIterated<dim>(QTrapezoid<1>(), 2).get_points())
    {
      functions.emplace_back();
      for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
        if (const double value = element.shape_value(i, point);
            std::abs(value) > 1e-12)
          functions.back().emplace_back(i, value);
    }
  return functions;
}



/** One cell in a batch. */
struct Lane
{
  const CellBatch &batch;
  const unsigned int n_lanes, lane;

  /** A vector at a point of the cell. */
  template <int dim>
  Tensor<1, dim>
  value(const double *const vector, const Functions &functions) const
  {
    Tensor<1, dim> sum;
    for (const auto &[node, weight] : functions)
      {
        const double *const at = vector + batch.nodes[node * n_lanes + lane];
        for (unsigned int c = 0; c < dim; ++c)
          sum[c] += weight * at[c];
      }
    return sum;
  }
};



/** The numbers of a process's own cells, counted from 0, by their
 * active_cell_index(). */
template <int dim>
std::vector<unsigned int>
numbers_of_own(const Discretization<dim> &discretization)
{
  unsigned int n = 0;
  std::vector<unsigned int> numbers;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    {
      numbers.push_back(n);
      n += cell->is_locally_owned();
    }
  return numbers;
}
} // namespace


template <int dim>
QuadraticPatches<dim>::QuadraticPatches(
  ElasticModel<dim> &model,
  const LA::Vector &displacement,
  const std::vector<CellValues> &cell_values)
{
  constexpr unsigned int n_points = Utilities::pow(3, dim);
  auto &batches                   = model.batches();
  const auto &cells               = batches.cells();
  const auto numbers              = numbers_of_own(model.discretization);
  const auto functions =
    functions_on_grid(model.discretization.fe.base_element(0));
  const ShownStress<dim> stress(model, displacement);
  auto u = batches.imported(displacement);
  u.update_ghost_values();
  const double *const positions = batches.positions().begin();

  names.assign(dim, "displacement");
  for (const auto &name : stress.names())
    names.push_back(name);
  for (const auto &[name, values] : cell_values)
    names.push_back(name);
  patches.resize(cells.size());

  visit_gradients<dim>(model, u, [&](const GradientsOfBatch &gradients) {
    for (unsigned int lane = 0; lane < gradients.batch.n_cells; ++lane)
      {
        const auto &cell = cells[gradients.first_cell + lane];
        const Lane here{gradients.batch, gradients.n_lanes, lane};
        const unsigned int number = numbers[cell->active_cell_index()];
        Patch &patch              = patches[number];
        patch.patch_index         = number;
        patch.n_subdivisions      = 2;
        for (const unsigned int v : cell->vertex_indices())
          patch.vertices[v] = cell->vertex(v);
        patch.points_are_available = true;
        auto &data                 = patch.data;
        data.reinit(TableIndices<2>(names.size() + dim, n_points), true);
        for (unsigned int p = 0; p < n_points; ++p)
          {
            const auto shift = here.value<dim>(u.begin(), functions[p]);
            const Point<dim> point(here.value<dim>(positions, functions[p]));
            for (unsigned int c = 0; c < dim; ++c)
              {
                data(c, p)                = shift[c];
                data(names.size() + c, p) = point[c];
              }
            stress.evaluate(cell,
                            point,
                            gradients.at<dim>(p, lane),
                            [&](const unsigned int n) -> float & {
                              return data(dim + n, p);
                            });
          }
        unsigned int row = dim + stress.n_values;
        for (const auto &[name, values] : cell_values)
          {
            for (unsigned int p = 0; p < n_points; ++p)
              data(row, p) = values(cell->active_cell_index());
            ++row;
          }
      }
  });
}



template <int dim>
const std::vector<typename QuadraticPatches<dim>::Patch> &
QuadraticPatches<dim>::get_patches() const
{
  return patches;
}



template <int dim>
std::vector<std::string>
QuadraticPatches<dim>::get_dataset_names() const
{
  return names;
}



template <int dim>
std::vector<
  std::tuple<unsigned int,
             unsigned int,
             std::string,
             DataComponentInterpretation::DataComponentInterpretation>>
QuadraticPatches<dim>::get_nonscalar_data_ranges() const
{
  return {{0,
           dim - 1,
           "displacement",
           DataComponentInterpretation::component_is_part_of_vector},
          {dim,
           dim + dim * dim - 1,
           "stress",
           DataComponentInterpretation::component_is_part_of_tensor}};
}



template class QuadraticPatches<2>;
template class QuadraticPatches<3>;
} // namespace Setsudan
