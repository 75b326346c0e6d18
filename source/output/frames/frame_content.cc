// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/mechanics/strain_and_stress.h>
#include <setsudan/mechanics/stress/grid_gradients.h>
#include <setsudan/mechanics/stress/stress_evaluator.h>
#include <setsudan/output/frames/frame_content.h>
#include <setsudan/output/frames/frame_fields.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Setsudan
{
using namespace dealii;

namespace
{
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



/** Set the type of a grid's cells, and which points they have: their own, x
 * fastest.
 *
 * @param order the points of a cell in VTK's order. */
void
set_cells(const unsigned char type,
          const std::vector<unsigned int> &order,
          const unsigned int n_cells,
          VtuGrid &grid)
{
  grid.type             = type;
  grid.n_points_of_cell = order.size();
  grid.connectivity.reserve(n_cells * order.size());
  for (unsigned int cell = 0; cell < n_cells; ++cell)
    for (const unsigned int place : order)
      grid.connectivity.push_back(cell * order.size() + place);
}

/** Whether the digits of single precision leave less of the smallest line of
 * the cells than a picture needs: so it is far from the origin. */
template <int dim>
bool
needs_double(const Discretization<dim> &discretization)
{
  double largest = 0, shortest = std::numeric_limits<double>::max();
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        for (const unsigned int v : cell->vertex_indices())
          largest = std::max(largest, cell->vertex(v).norm());
        shortest = std::min(shortest, cell->minimum_vertex_distance());
      }
  const MPI_Comm communicator = discretization.communicator;
  largest                     = Utilities::MPI::max(largest, communicator);
  shortest                    = Utilities::MPI::min(shortest, communicator);
  return largest * std::numeric_limits<float>::epsilon() > 1e-4 * shortest;
}

template <int dim>
void
show_linear_cells(const ElasticModel<dim> &model,
                  const LA::Vector &displacement,
                  VtuGrid &grid)
{
  const auto &discretization      = model.discretization;
  constexpr unsigned int n_points = GeometryInfo<dim>::vertices_per_cell;
  const unsigned int n_cells =
    discretization.triangulation.n_locally_owned_active_cells();
  // VTK's quadrilateral and hexahedron.
  set_cells(dim == 2 ? 9 : 12,
            dim == 2 ? std::vector<unsigned int>{0, 1, 3, 2}
                     : std::vector<unsigned int>{0, 1, 3, 2, 4, 5, 7, 6},
            n_cells,
            grid);
  FrameFields<dim> fields(n_points * n_cells);
  StressEvaluator<dim> recovery(discretization,
                                model.materials,
                                node_points(discretization),
                                &model.internal);
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
            fields.set(point++,
                       positions[node],
                       u,
                       recovery.strain(node),
                       recovery.stress(node));
          }
      }
  fields.move_into(grid, needs_double(discretization));
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
void
show_quadratic_cells(const ElasticModel<dim> &model,
                     const LA::Vector &displacement,
                     VtuGrid &grid)
{
  constexpr unsigned int n_points = Utilities::pow(3, dim);
  const auto &discretization      = model.discretization;
  auto &batches                   = model.batches();
  // VTK's quadratic Lagrange quadrilateral and hexahedron.
  set_cells(dim == 2 ? 70 : 72,
            dim == 2
              ? std::vector<unsigned int>{0, 2, 8, 6, 1, 5, 7, 3, 4}
              : std::vector<unsigned int>{0,  2,  8,  6,  18, 20, 26, 24, 1,
                                          5,  7,  3,  19, 23, 25, 21, 9,  11,
                                          15, 17, 12, 14, 10, 16, 4,  22, 13},
            batches.cells().size(),
            grid);
  FrameFields<dim> fields(n_points * batches.cells().size());
  std::unique_ptr<Dilatation<dim>> dilatation;
  if (model.materials.any_is_mixed())
    dilatation = std::make_unique<Dilatation<dim>>(discretization);
  std::unique_ptr<StressEvaluator<dim>> with_memory;
  if (!model.internal.empty())
    with_memory =
      std::make_unique<StressEvaluator<dim>>(discretization,
                                             model.materials,
                                             QIterated<dim>(QTrapezoid<1>(), 2),
                                             &model.internal);
  const auto functions = functions_on_grid(discretization.fe.base_element(0));
  const auto numbers   = numbers_of_own(discretization);
  auto u               = batches.copy_in(displacement);
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
          dilatation_of_cell = (*dilatation)(cell, material, displacement);
        if (with_memory)
          with_memory->reinit(cell, displacement);
        for (unsigned int p = 0; p < n_points; ++p)
          {
            const Point<dim> position(
              value_at<dim>(positions, functions[p], batch, lane));
            const auto gradient = batch.at<dim>(p, lane);
            fields.set(
              numbers[cell->active_cell_index()] * n_points + p,
              position,
              value_at<dim>(u.begin(), functions[p], batch, lane),
              strain_of(material, gradient),
              with_memory
                ? with_memory->stress(p)
                : stress_of(material, gradient, position, dilatation_of_cell));
          }
      }
  });
  fields.move_into(grid, needs_double(discretization));
}

/** Add which nodes of the body the points are, and whether the front is there.
 */
template <int dim>
void
add_nodes(const Body<dim> &body,
          const Discretization<dim> &discretization,
          const std::vector<types::global_dof_index> &front,
          VtuGrid &grid)
{
  const unsigned int n_points = grid.n_points_of_cell;
  const unsigned int n_1d = discretization.type == ElementType::linear ? 2 : 3;
  std::vector<unsigned int> places;
  for (const auto &node : discretization.nodes())
    {
      unsigned int place = 0;
      for (int c = dim - 1; c >= 0; --c)
        place = place * n_1d + std::lround(node[c] * (n_1d - 1));
      places.push_back(place);
    }
  std::vector<std::int32_t> nodes(grid.connectivity.size(), -1);
  std::vector<std::int32_t> at_front(nodes.size(), 0);
  std::size_t first = 0;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const auto &numbers = body.node_numbers[discretization.element(cell)];
        const auto indices  = discretization.node_indices(cell);
        // Cells that are whole elements have the body's nodes first.
        const bool is_whole = cell->level() == 0;
        const auto points   = is_whole ? std::vector<Point<dim>>()
                                       : discretization.points_in_element(cell);
        for (unsigned int node = 0; node < indices.size(); ++node)
          {
            if (is_whole && node < n_element_nodes<dim>)
              nodes[first + places[node]] = numbers[node];
            else if (!is_whole)
              if (const auto of_body = node_at(points[node]))
                nodes[first + places[node]] = numbers[*of_body];
            at_front[first + places[node]] =
              std::binary_search(front.begin(), front.end(), indices[node][0]);
          }
        first += n_points;
      }
  grid.point_data.push_back({"node", 1, std::move(nodes)});
  grid.point_data.push_back({"front", 1, std::move(at_front)});
}

/** Add what is the same at all points of a cell. */
template <int dim>
void
add_cell_data(const ElasticModel<dim> &model,
              const ElementLabels &labels,
              const dealii::Vector<double> &error_squares,
              VtuGrid &grid)
{
  const auto &discretization = model.discretization;
  using Cell                 = typename Discretization<dim>::Cell;
  const auto add = [&](const std::string &name, auto of_cells, const auto &of) {
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        of_cells.push_back(of(cell));
    grid.cell_data.push_back({name, 1, std::move(of_cells)});
  };
  const auto element = [&](const Cell &cell) {
    return discretization.element(cell);
  };
  const std::vector<std::int32_t> numbers;
  add("element", numbers, element);
  add("side", numbers, [&](const Cell &cell) {
    return labels.side[element(cell)];
  });
  add("piece", numbers, [&](const Cell &cell) {
    return labels.piece[element(cell)];
  });
  add("material", numbers, [&](const Cell &cell) {
    return model.materials.number(element(cell));
  });
  if (error_squares.size() > 0)
    add("energy_error", std::vector<float>(), [&](const Cell &cell) {
      return std::sqrt(error_squares[cell->active_cell_index()]);
    });
}
} // namespace



template <int dim>
VtuGrid
frame_content(const Body<dim> &body,
              const ElasticModel<dim> &model,
              const LA::Vector &displacement,
              const ElementLabels &labels,
              const dealii::Vector<double> &error_squares,
              const FrameFacts &facts)
{
  VtuGrid grid;
  if (model.discretization.type == ElementType::linear)
    show_linear_cells(model, displacement, grid);
  else
    show_quadratic_cells(model, displacement, grid);
  add_nodes(body, model.discretization, facts.front, grid);
  add_cell_data(model, labels, error_squares, grid);
  grid.field_data = facts.of_state;
  return grid;
}



template VtuGrid
frame_content(const Body<2> &,
              const ElasticModel<2> &,
              const LA::Vector &,
              const ElementLabels &,
              const dealii::Vector<double> &,
              const FrameFacts &);
template VtuGrid
frame_content(const Body<3> &,
              const ElasticModel<3> &,
              const LA::Vector &,
              const ElementLabels &,
              const dealii::Vector<double> &,
              const FrameFacts &);
} // namespace Setsudan
