// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/mechanics/stress/patch_fit.h>
#include <setsudan/mechanics/stress/recovered_stress.h>

#include <cmath>
#include <map>
#include <set>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** The components of a stress that can differ from 0, in the order in which
 * they are kept. */
template <int dim>
std::vector<TableIndices<2>>
components()
{
  if constexpr (dim == 2)
    return {{0, 0}, {1, 1}, {2, 2}, {0, 1}};
  else
    return {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}};
}



/** What is needed of a cell: its nodes, and the stress where it is accurate. */
template <int dim>
struct Sampled
{
  std::vector<typename Discretization<dim>::NodeIndices> indices;
  std::vector<Point<dim>> positions;
  std::vector<Point<dim>> points;
  std::vector<SymmetricTensor<2, 3>> stresses;
};



/** The cells of a material that this process knows. */
template <int dim>
std::vector<Sampled<dim>>
sample_cells(const ElasticModel<dim> &model,
             const unsigned int material,
             const LA::Vector &displacement)
{
  const auto &discretization = model.discretization;
  // Where the stress of linear or quadratic elements is of a higher order.
  StressEvaluator<dim> recovery(
    discretization,
    model.materials,
    QGauss<dim>(discretization.n_gauss_points() - 1));
  std::vector<Sampled<dim>> cells;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (!cell->is_artificial() &&
        model.materials.number(discretization.element(cell)) == material)
      {
        recovery.reinit(cell, displacement);
        std::vector<Point<dim>> points;
        for (unsigned int p = 0; p < recovery.n_points(); ++p)
          points.push_back(recovery.point(p));
        cells.push_back({discretization.node_indices(cell),
                         discretization.node_positions(cell),
                         points,
                         recovery.stresses()});
      }
  return cells;
}



/** Values at nodes from several patches, of which the best ones count. */
template <int dim, std::size_t n_vectors>
class NodeMeans
{
public:
  /** The node's own patch or one beside it; with as many functions as any, or
   * with fewer. */
  enum Quality
  {
    own_complete,
    complete,
    own,
    any,
    n_qualities
  };

  explicit NodeMeans(const Discretization<dim> &discretization)
    : discretization(discretization)
  {
    for (auto &level : levels)
      {
        for (auto &sum : level.sums)
          sum = discretization.zero_vector();
        level.counts = discretization.zero_vector();
      }
  }

  void
  add(const Quality quality,
      const typename Discretization<dim>::NodeIndices &node,
      const SymmetricTensor<2, 3> &stress)
  {
    static const auto kept = components<dim>();
    for (unsigned int k = 0; k < kept.size(); ++k)
      levels[quality].sums[k / dim](node[k % dim]) += stress[kept[k]];
    for (const auto index : node)
      levels[quality].counts(index) += 1;
  }

  std::array<LA::Vector, n_vectors>
  finish()
  {
    std::array<LA::Vector, n_vectors> means;
    for (auto &level : levels)
      {
        for (auto &sum : level.sums)
          sum.compress(VectorOperation::add);
        level.counts.compress(VectorOperation::add);
      }
    for (unsigned int v = 0; v < n_vectors; ++v)
      {
        means[v] = discretization.zero_vector();
        for (const auto index : discretization.owned)
          for (const auto &level : levels)
            if (level.counts(index) > 0)
              {
                means[v](index) = level.sums[v](index) / level.counts(index);
                break;
              }
        means[v].compress(VectorOperation::insert);
      }
    return means;
  }

private:
  struct Level
  {
    std::array<LA::Vector, n_vectors> sums;
    LA::Vector counts;
  };

  const Discretization<dim> &discretization;
  std::array<Level, n_qualities> levels;
};



/** The cells around a vertex, each with its number of the vertex, and the fit
 * to their samples. */
template <int dim>
struct Patch
{
  Patch(const std::vector<Sampled<dim>> &all_cells,
        const std::vector<std::pair<unsigned int, unsigned int>> &cells)
    : cells(cells)
    , fit(make_fit(all_cells))
  {
  }

  std::vector<std::pair<unsigned int, unsigned int>> cells;
  PatchFit<dim> fit;

private:
  PatchFit<dim>
  make_fit(const std::vector<Sampled<dim>> &all_cells) const
  {
    const auto &[cell, vertex] = cells.front();
    const Point<dim> center    = all_cells[cell].positions[vertex];
    std::vector<Point<dim>> points;
    double size = 0;
    for (const auto &[c, v] : cells)
      for (const auto &point : all_cells[c].points)
        {
          points.push_back(point);
          size = std::max(size, point.distance(center));
        }
    return PatchFit<dim>(points, center, size);
  }
};



/** Whether a node lies on the near half of the cell, as a vertex sees it. */
template <int dim>
bool
is_near_vertex(const Point<dim> &node, const unsigned int vertex)
{
  bool is_near = true;
  for (unsigned int d = 0; d < dim; ++d)
    is_near =
      is_near &&
      std::abs(node[d] - GeometryInfo<dim>::unit_cell_vertex(vertex)[d]) < 0.75;
  return is_near;
}



/** Hand the stress of a patch to the nodes of its cells. */
template <int dim, std::size_t n_vectors>
void
add_patch(const std::vector<Sampled<dim>> &cells,
          const std::vector<Point<dim>> &nodes,
          const Patch<dim> &patch,
          const unsigned int n_functions,
          NodeMeans<dim, n_vectors> &means)
{
  using Means            = NodeMeans<dim, n_vectors>;
  const bool is_complete = patch.fit.n_functions() == n_functions;
  std::set<types::global_dof_index> done;
  for (const auto &[c, vertex] : patch.cells)
    for (unsigned int node = 0; node < nodes.size(); ++node)
      {
        if (!done.insert(cells[c].indices[node][0]).second)
          continue;
        const bool is_own  = is_near_vertex(nodes[node], vertex);
        const auto weights = patch.fit.weights_at(cells[c].positions[node]);
        SymmetricTensor<2, 3> stress;
        auto weight = weights.begin();
        for (const auto &[other, of_other] : patch.cells)
          for (const auto &sample : cells[other].stresses)
            stress += *weight++ * sample;
        means.add(is_complete ? (is_own ? Means::own_complete : Means::complete)
                              : (is_own ? Means::own : Means::any),
                  cells[c].indices[node],
                  stress);
      }
}
} // namespace


template <int dim>
RecoveredStress<dim>::RecoveredStress(const ElasticModel<dim> &model,
                                      const LA::Vector &displacement)
  : model(model)
{
  for (unsigned int m = 0; m < model.materials.n_materials(); ++m)
    fields.push_back(recover(m, displacement));
}



template <int dim>
typename RecoveredStress<dim>::Field
RecoveredStress<dim>::recover(const unsigned int material,
                              const LA::Vector &displacement) const
{
  const auto &discretization = model.discretization;
  const auto cells           = sample_cells(model, material, displacement);
  // Cells and their vertices, by the unknown of the vertex: the two sides of a
  // cut have different ones.
  std::map<types::global_dof_index,
           std::vector<std::pair<unsigned int, unsigned int>>>
    cells_at_vertex;
  for (unsigned int c = 0; c < cells.size(); ++c)
    for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_cell; ++v)
      if (discretization.owned.is_element(cells[c].indices[v][0]))
        cells_at_vertex[cells[c].indices[v][0]].emplace_back(c, v);

  std::vector<Patch<dim>> patches;
  unsigned int n_functions = 0;
  for (const auto &[index, around] : cells_at_vertex)
    {
      patches.emplace_back(cells, around);
      n_functions = std::max(n_functions, patches.back().fit.n_functions());
    }
  // A body of one layer of elements has no patch with all functions.
  n_functions = Utilities::MPI::max(n_functions, discretization.communicator);
  NodeMeans<dim, n_vectors> means(discretization);
  for (const auto &patch : patches)
    add_patch(cells, discretization.nodes(), patch, n_functions, means);
  Field field = means.finish();
  for (auto &vector : field)
    {
      distribute(model.hanging, vector);
      vector = discretization.with_ghosts(vector);
    }
  return field;
}



template <int dim>
std::vector<SymmetricTensor<2, 3>>
RecoveredStress<dim>::evaluate(const Cell &cell,
                               const StressEvaluator<dim> &points) const
{
  static const auto kept = components<dim>();
  const auto &of_material =
    fields[model.materials.number(model.discretization.element(cell))];
  std::vector<SymmetricTensor<2, 3>> stresses(points.n_points());
  for (unsigned int v = 0; v < n_vectors; ++v)
    {
      const auto values = points.values(of_material[v]);
      for (unsigned int q = 0; q < stresses.size(); ++q)
        for (unsigned int c = 0; c < dim && v * dim + c < kept.size(); ++c)
          stresses[q][kept[v * dim + c]] = values[q][c];
    }
  return stresses;
}



template class RecoveredStress<2>;
template class RecoveredStress<3>;
} // namespace Setsudan
