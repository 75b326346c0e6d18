#include <deal.II/base/quadrature_lib.h>

#include <setsudan/elasticity/grid_gradients.h>
#include <setsudan/elasticity/strain_recovery.h>
#include <setsudan/output/frame_content.h>

#include <cmath>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The maximum shear up to the digits that a frame has, in a fraction of the
 * time that maximum_shear() takes. */
double
shown_shear(const SymmetricTensor<2, 3> &stress)
{
  const auto principal = eigenvalues(stress);
  return (principal[0] - principal[2]) / 2;
}



/** The arrays of points, which are filled cell by cell, x fastest in a cell. */
template <int dim>
class PointArrays
{
public:
  PointArrays(const unsigned int n_points, VtuCells &cells)
    : cells(cells)
  {
    cells.points.resize(3 * n_points);
    cells.data = {{"displacement", 3, std::vector<float>(3 * n_points)},
                  {"stress", 9, std::vector<float>(9 * n_points)},
                  {"maximum_shear", 1, std::vector<float>(n_points)},
                  {"stress_zz", 1, std::vector<float>(n_points)}};
  }

  void
  set(const unsigned int point,
      const Point<dim> &position,
      const Tensor<1, dim> &displacement,
      const SymmetricTensor<2, 3> &stress)
  {
    float *const tensor = &cells.data[1].values[9 * point];
    for (unsigned int c = 0; c < dim; ++c)
      {
        cells.points[3 * point + c]         = position[c];
        cells.data[0].values[3 * point + c] = displacement[c];
        for (unsigned int d = 0; d < dim; ++d)
          tensor[3 * c + d] = stress[c][d];
      }
    cells.data[2].values[point] = shown_shear(stress);
    cells.data[3].values[point] = stress[2][2];
  }

private:
  VtuCells &cells;
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



template <int dim>
VtuCells
linear_cells(const ElasticModel<dim> &model, const LA::Vector &displacement)
{
  const auto &discretization      = model.discretization;
  constexpr unsigned int n_points = GeometryInfo<dim>::vertices_per_cell;
  VtuCells content;
  // VTK's quadrilateral and hexahedron.
  content.type  = dim == 2 ? 9 : 12;
  content.order = dim == 2 ? std::vector<unsigned int>{0, 1, 3, 2}
                           : std::vector<unsigned int>{0, 1, 3, 2, 4, 5, 7, 6};
  PointArrays<dim> arrays(
    n_points * discretization.triangulation.n_locally_owned_active_cells(),
    content);
  StrainRecovery<dim> recovery(
    discretization, model.materials, node_points(discretization));
  unsigned int point = 0;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        recovery.reinit(cell, displacement);
        const auto positions = discretization.node_positions(cell);
        const auto indices   = discretization.node_indices(cell);
        for (unsigned int node = 0; node < n_points; ++node)
          {
            Tensor<1, dim> u;
            for (unsigned int c = 0; c < dim; ++c)
              u[c] = displacement(indices[node][c]);
            arrays.set(point++, positions[node], u, recovery.stress(node));
          }
      }
  return content;
}



/** The functions of an element at a point that differ from 0 there. */
using Functions = std::vector<std::pair<unsigned int, double>>;

/** The functions at the points of a cell, x fastest. */
template <int dim>
std::vector<Functions>
functions_on_grid(const FiniteElement<dim> &element)
{
  const QIterated<dim> grid(QTrapezoid<1>(), 2);
  std::vector<Functions> functions;
  for (const auto &point : grid.get_points())
    {
      functions.emplace_back();
      for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
        if (const double value = element.shape_value(i, point);
            std::abs(value) > 1e-12)
          functions.back().emplace_back(i, value);
    }
  return functions;
}



/** A vector at a point of the cell in a lane of a batch. */
template <int dim>
Tensor<1, dim>
value_at(const double *const vector,
         const Functions &functions,
         const GradientsOfBatch &batch,
         const unsigned int lane)
{
  Tensor<1, dim> sum;
  for (const auto &[node, weight] : functions)
    {
      const double *const at =
        vector + batch.batch.nodes[node * batch.n_lanes + lane];
      for (unsigned int c = 0; c < dim; ++c)
        sum[c] += weight * at[c];
    }
  return sum;
}



template <int dim>
VtuCells
quadratic_cells(ElasticModel<dim> &model, const LA::Vector &displacement)
{
  constexpr unsigned int n_points = Utilities::pow(3, dim);
  const auto &discretization      = model.discretization;
  auto &batches                   = model.batches();
  VtuCells content;
  // VTK's quadratic Lagrange quadrilateral and hexahedron.
  content.type = dim == 2 ? 70 : 72;
  content.order =
    dim == 2 ? std::vector<unsigned int>{0, 2, 8, 6, 1, 5, 7, 3, 4}
             : std::vector<unsigned int>{0,  2,  8,  6,  18, 20, 26, 24, 1,
                                         5,  7,  3,  19, 23, 25, 21, 9,  11,
                                         15, 17, 12, 14, 10, 16, 4,  22, 13};
  PointArrays<dim> arrays(n_points * batches.cells().size(), content);
  std::unique_ptr<Dilatation<dim>> dilatation;
  if (model.materials.any_is_mixed())
    dilatation = std::make_unique<Dilatation<dim>>(discretization);
  const auto functions = functions_on_grid(discretization.fe.base_element(0));
  const auto numbers   = numbers_of_own(discretization);
  auto u               = batches.imported(displacement);
  u.update_ghost_values();
  const double *const positions = batches.positions().begin();
  visit_gradients<dim>(model, u, [&](const GradientsOfBatch &batch) {
    for (unsigned int lane = 0; lane < batch.batch.n_cells; ++lane)
      {
        const auto &cell = batches.cells()[batch.first_cell + lane];
        const Material &material =
          model.materials.of_element(discretization.element(cell));
        LinearFunction<dim> dilatation_of_cell;
        if (material.is_mixed)
          dilatation_of_cell = (*dilatation)(cell, displacement);
        for (unsigned int p = 0; p < n_points; ++p)
          {
            const Point<dim> position(
              value_at<dim>(positions, functions[p], batch, lane));
            const auto strain = symmetrize(batch.at<dim>(p, lane));
            arrays.set(
              numbers[cell->active_cell_index()] * n_points + p,
              position,
              value_at<dim>(u.begin(), functions[p], batch, lane),
              material.is_mixed
                ? material.hooke.stress(strain, dilatation_of_cell(position))
                : material.hooke.stress(strain));
          }
      }
  });
  return content;
}



/** Add what is the same at all points of a cell. */
template <int dim>
void
add_cell_data(const ElasticModel<dim> &model,
              const ElementLabels &labels,
              const dealii::Vector<double> &error_squares,
              VtuCells &content)
{
  const auto &discretization = model.discretization;
  using Cell                 = typename Discretization<dim>::Cell;
  const auto add = [&](const std::string &name, const auto &value_of_cell) {
    content.data.push_back({name, 1, {}});
    auto &values = content.data.back().values;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        values.insert(values.end(), content.order.size(), value_of_cell(cell));
  };
  const auto element = [&](const Cell &cell) {
    return discretization.element(cell);
  };
  add("side", [&](const Cell &cell) { return labels.side[element(cell)]; });
  add("piece", [&](const Cell &cell) { return labels.piece[element(cell)]; });
  add("material",
      [&](const Cell &cell) { return model.materials.number(element(cell)); });
  if (error_squares.size() > 0)
    add("energy_error", [&](const Cell &cell) {
      return std::sqrt(error_squares[cell->active_cell_index()]);
    });
}
} // namespace


template <int dim>
VtuCells
frame_content(ElasticModel<dim> &model,
              const LA::Vector &displacement,
              const ElementLabels &labels,
              const dealii::Vector<double> &error_squares)
{
  VtuCells content = model.discretization.type == ElementType::linear
                       ? linear_cells(model, displacement)
                       : quadratic_cells(model, displacement);
  add_cell_data(model, labels, error_squares, content);
  return content;
}



template VtuCells
frame_content(ElasticModel<2> &,
              const LA::Vector &,
              const ElementLabels &,
              const dealii::Vector<double> &);
template VtuCells
frame_content(ElasticModel<3> &,
              const LA::Vector &,
              const ElementLabels &,
              const dealii::Vector<double> &);
} // namespace Setsudan
