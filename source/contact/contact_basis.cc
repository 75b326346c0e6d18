// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <setsudan/contact/contact_basis.h>

#include <algorithm>
#include <map>
#include <set>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** Weights of nodes under the hats of corners: by pair of the corner and pair
 * of the node. */
using HatWeights = std::map<unsigned int, std::map<unsigned int, double>>;

/** Integrates the weights of the nodes of the cut's faces. */
template <int dim>
class HatIntegrator
{
public:
  HatIntegrator(const ElasticModel<dim> &model,
                const std::vector<NodePair<dim>> &pairs)
    : discretization(model.discretization)
    , linear(1)
    , gauss(discretization.n_gauss_points())
    , hats(discretization.mapping(), linear, gauss, update_values)
    , shapes(discretization.mapping(),
             discretization.fe.base_element(0),
             gauss,
             update_values | update_JxW_values)
  {
    for (unsigned int p = 0; p < pairs.size(); ++p)
      pair_of[pairs[p].minus[0]] = p;
  }

  /** Add the part of a face of an element on the minus side. */
  void
  add(const typename Discretization<dim>::Cell &cell, const unsigned int face)
  {
    const typename Triangulation<dim>::cell_iterator in_mesh = cell;
    hats.reinit(in_mesh, face);
    shapes.reinit(in_mesh, face);
    const auto nodes  = discretization.node_indices(cell);
    const auto &units = discretization.nodes();
    for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
      for (unsigned int k = 0; k < nodes.size(); ++k)
        if (GeometryInfo<dim>::unit_cell_vertex(v)[face / 2] == face % 2 &&
            units[k][face / 2] == face % 2)
          {
            double weight = 0;
            for (const unsigned int q : shapes.quadrature_point_indices())
              weight += hats.shape_value(v, q) * shapes.shape_value(k, q) *
                        shapes.JxW(q);
            // The first nodes of a cell are its vertices.
            weights[pair_of.at(nodes[v][0])][pair_of.at(nodes[k][0])] += weight;
          }
  }

  HatWeights weights;

private:
  const Discretization<dim> &discretization;
  const FE_Q<dim> linear;
  const QGauss<dim - 1> gauss;
  FEFaceValues<dim> hats, shapes;
  std::map<types::global_dof_index, unsigned int> pair_of;
};



/** A corner on the border between processes has faces on several. */
HatWeights
sum_over_processes(const HatWeights &weights, const MPI_Comm communicator)
{
  HatWeights sum;
  for (const auto &of_process :
       Utilities::MPI::all_gather(communicator, weights))
    for (const auto &[corner, of_corner] : of_process)
      for (const auto &[pair, weight] : of_corner)
        sum[corner][pair] += weight;
  return sum;
}



/** The weights of a cut's nodes. */
template <int dim>
HatWeights
hat_weights(const ElasticModel<dim> &model, const CutFaces<dim> &cut)
{
  std::multimap<unsigned int, unsigned int> faces;
  for (const auto &face : cut.surface)
    faces.insert(face.minus);
  HatIntegrator<dim> integrator(model, cut.pairs);
  const auto &discretization = model.discretization;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    {
      if (!cell->is_locally_owned())
        continue;
      const auto range  = faces.equal_range(discretization.element(cell));
      const auto points = range.first == range.second
                            ? std::vector<Point<dim>>()
                            : discretization.points_in_element(cell);
      for (auto it = range.first; it != range.second; ++it)
        {
          const unsigned int face = it->second;
          // A refined cell may lie away from its element's face.
          const unsigned int corner =
            GeometryInfo<dim>::face_to_cell_vertices(face, 0);
          if (points[corner][face / 2] == face % 2)
            integrator.add(cell, face);
        }
    }
  return sum_over_processes(integrator.weights, discretization.communicator);
}



/** The row of each pair, and beyond the last one for pairs of none. */
template <int dim>
std::vector<unsigned int>
rows_of_pairs(const Seam<dim> &seam)
{
  std::vector<unsigned int> rows(seam.pairs().size(), seam.rows().size());
  for (unsigned int row = 0; row < seam.rows().size(); ++row)
    for (const unsigned int pair : seam.rows()[row].pairs)
      rows[pair] = row;
  return rows;
}



/** Along the edge, where there is one. */
template <int dim>
Tensor<1, dim>
aside_at([[maybe_unused]] const NodePair<dim> &pair,
         [[maybe_unused]] const BladeEdge<dim> &edge)
{
  Tensor<1, dim> aside;
  if constexpr (dim == 3)
    aside = cross_product_3d(pair.normal, edge.direction);
  return aside;
}
} // namespace


template <int dim>
ContactBasis<dim>::ContactBasis(const ElasticModel<dim> &model,
                                const CutSurface<dim> &surface,
                                const Seam<dim> &seam,
                                const BladeEdge<dim> &edge,
                                const TouchingBlade &blade,
                                const std::vector<CutFaces<dim>> &earlier)
  : blade(blade)
  , mpi_communicator(model.discretization.communicator)
{
  const auto &pairs   = seam.pairs();
  const double entry  = travels_of_pairs(pairs, edge)[0];
  const auto depth_of = [&](const unsigned int pair) {
    return edge.travel(pairs[pair].position) - entry;
  };

  const auto rows = rows_of_pairs(seam);
  row_of_opening  = rows;
  for (unsigned int p = 0; p < pairs.size(); ++p)
    if (!pairs[p].is_double() ||
        pairs[p].supported[pairs[p].normal_component()])
      row_of_opening[p] = seam.rows().size();
  for (const auto &[corner, weights] :
       hat_weights(model, {surface, seam.pairs()}))
    if (pairs[corner].is_double())
      {
        Hat hat{
          corner, rows[corner], 0., 0., 0., {weights.begin(), weights.end()}};
        for (const auto &[pair, weight] : weights)
          {
            hat.area += weight;
            hat.depth += weight * depth_of(pair);
            hat.across += weight * (pairs[pair].normal * edge.normal);
          }
        hat.depth /= hat.area;
        all_hats.push_back(hat);
      }
  if (blade.has_flanks)
    make_flank_vectors(seam, edge);
  else
    for (const auto &hat : all_hats)
      add_gap_vector(pairs, hat.weights);
  if (blade.has_edge)
    make_edge_vectors(seam, edge);
  for (const auto &cut : earlier)
    add_earlier_walls(model, cut);
}



template <int dim>
void
ContactBasis<dim>::make_edge_vectors(const Seam<dim> &seam,
                                     const BladeEdge<dim> &edge)
{
  for (unsigned int row = 0; row < seam.rows().size(); ++row)
    {
      // A front that is closed, or branches, has a node more than once. The
      // edge takes the front's shape: a straight one would stick on the nodes
      // of a front that is not.
      std::set<unsigned int> taken;
      for (const unsigned int pair : seam.rows()[row].front)
        if (taken.insert(pair).second)
          all_edge_nodes.push_back({pair, row, seam.rows()[row].depth});
    }
  for (const auto &node : all_edge_nodes)
    {
      UnknownForces vector;
      const auto &pair = seam.pairs()[node.pair];
      const Tensor<1, dim> way =
        edge.direction + blade.sliding.drag() * aside_at(pair, edge);
      for (unsigned int c = 0; c < dim; ++c)
        vector.emplace_back(pair.minus[c], way[c]);
      all_vectors.push_back(vector);
    }
}



template <int dim>
void
ContactBasis<dim>::add_gap_vector(const std::vector<NodePair<dim>> &pairs,
                                  const NodeWeights &weights)
{
  UnknownForces vector;
  for (const auto &[p, weight] : weights)
    for (unsigned int c = 0; c < dim; ++c)
      {
        const double apart = weight * pairs[p].normal[c];
        vector.emplace_back(pairs[p].plus[c], apart);
        vector.emplace_back(pairs[p].minus[c], -apart);
      }
  all_vectors.push_back(vector);
}



template <int dim>
void
ContactBasis<dim>::add_earlier_walls(const ElasticModel<dim> &model,
                                     const CutFaces<dim> &cut)
{
  for (const auto &[corner, weights] : hat_weights(model, cut))
    if (cut.pairs[corner].is_double())
      {
        add_gap_vector(cut.pairs, {weights.begin(), weights.end()});
        areas_of_earlier_corners.push_back(0);
        for (const auto &[pair, weight] : weights)
          areas_of_earlier_corners.back() += weight;
      }
}



template <int dim>
double
ContactBasis<dim>::split_area(const unsigned int hat,
                              const unsigned int n_split) const
{
  double area = 0;
  for (const auto &[pair, weight] : all_hats[hat].weights)
    if (row_of_opening[pair] < n_split)
      area += weight;
  return area;
}



template <int dim>
void
ContactBasis<dim>::make_flank_vectors(const Seam<dim> &seam,
                                      const BladeEdge<dim> &edge)
{
  const auto way_of =
    [&](const NodePair<dim> &pair, const Wall wall, const Component component) {
      switch (component)
        {
          case Component::along:
            return edge.direction;
          case Component::aside:
            return aside_at(pair, edge);
          default:
            return wall == Wall::plus ? pair.normal : -pair.normal;
        }
    };
  std::vector<Component> components = {Component::outward, Component::along};
  if (blade.sliding.rubs_aside())
    components.push_back(Component::aside);
  for (const auto &hat : all_hats)
    for (const Wall wall : {Wall::minus, Wall::plus})
      for (const Component component : components)
        {
          UnknownForces vector;
          for (const auto &[p, weight] : hat.weights)
            {
              const auto &pair         = seam.pairs()[p];
              const Tensor<1, dim> way = way_of(pair, wall, component);
              for (unsigned int c = 0; c < dim; ++c)
                vector.emplace_back(
                  (wall == Wall::plus ? pair.plus : pair.minus)[c],
                  weight * way[c]);
            }
          all_vectors.push_back(vector);
        }
}



template <int dim>
unsigned int
ContactBasis<dim>::vector_of_hat(const unsigned int hat,
                                 const Wall wall,
                                 const Component component) const
{
  return first_vector_of_hat(hat) +
         (wall == Wall::plus ? n_vectors_of_hat() / 2 : 0) +
         static_cast<unsigned int>(component);
}



template <int dim>
unsigned int
ContactBasis<dim>::vector_of_edge_node(const unsigned int node) const
{
  return first_vector_of_hat(all_hats.size()) + node;
}



template <int dim>
unsigned int
ContactBasis<dim>::first_vector_of_hat(const unsigned int hat) const
{
  return n_vectors_of_hat() * hat;
}



template class ContactBasis<2>;
template class ContactBasis<3>;
} // namespace Setsudan
