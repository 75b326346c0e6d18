// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/contact/contact_basis.h>
#include <setsudan/contact/face_hats.h>

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



/** The weights of a cut's nodes, which are the same on both of its sides. */
template <int dim>
HatWeights
hat_weights(const ElasticModel<dim> &model, const CutFaces<dim> &cut)
{
  std::map<types::global_dof_index, unsigned int> pair_of;
  for (unsigned int p = 0; p < cut.pairs.size(); ++p)
    pair_of[cut.pairs[p].minus[0]] = p;
  std::vector<CellFace> faces;
  for (const auto &face : cut.surface)
    faces.push_back(face.minus);
  HatWeights weights;
  for (const auto &hat : face_hats(model, faces))
    for (const auto &[node, weight] : hat.nodes)
      weights[pair_of.at(hat.corner[0])][pair_of.at(node[0])] = weight;
  return weights;
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



/** Along the edge, where there is one, at a normal of the cut. */
template <int dim>
Tensor<1, dim>
aside_at([[maybe_unused]] const Tensor<1, dim> &normal,
         [[maybe_unused]] const BladeEdge<dim> &edge)
{
  Tensor<1, dim> aside;
  if constexpr (dim == 3)
    aside = cross_product_3d(normal, edge.direction);
  return aside;
}
} // namespace


template <int dim>
ContactBasis<dim>::ContactBasis(const ElasticModel<dim> &model,
                                const CutSurface<dim> &surface,
                                const Seam<dim> &seam,
                                const BladeEdge<dim> &edge,
                                const TouchingBlade &blade,
                                const std::vector<CutFaces<dim>> &earlier,
                                const BoardContacts<dim> *board,
                                const std::vector<EntryHat<dim>> &outer)
  : blade(blade)
  , mpi_communicator(model.discretization.communicator)
  , the_board(board)
{
  make_hats(model, surface, seam, edge);
  n_hats_on_cut = all_hats.size();
  if (blade.has_flanks)
    {
      make_flank_vectors(seam, edge);
      add_outer_hats(outer, edge);
    }
  else
    for (const auto &hat : all_hats)
      add_gap_vector(seam.pairs(), hat.weights);
  if (blade.has_edge)
    make_edge_vectors(seam, edge);
  for (const auto &cut : earlier)
    add_earlier_walls(model, cut);
  if (board)
    add_board(*board);
}



template <int dim>
void
ContactBasis<dim>::make_hats(const ElasticModel<dim> &model,
                             const CutSurface<dim> &surface,
                             const Seam<dim> &seam,
                             const BladeEdge<dim> &edge)
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
        Hat hat{rows[corner], 0., 0., 0., {weights.begin(), weights.end()}};
        for (const auto &[pair, weight] : weights)
          {
            hat.area += weight;
            hat.depth += weight * depth_of(pair);
            hat.across += weight * (pairs[pair].normal * edge.normal);
          }
        hat.depth /= hat.area;
        all_hats.push_back(hat);
      }
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
        edge.direction + blade.sliding.drag() * aside_at(pair.normal, edge);
      for (unsigned int c = 0; c < dim; ++c)
        vector.emplace_back(pair.minus[c], way[c]);
      all_vectors.push_back(vector);
      if (!edge_holds())
        continue;
      for (unsigned int c = 0; c < dim; ++c)
        vector[c].second = pair.normal[c];
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
ContactBasis<dim>::ContactBasis(const MPI_Comm communicator,
                                const BoardContacts<dim> &board)
  : mpi_communicator(communicator)
  , the_board(&board)
{
  add_board(board);
}



template <int dim>
void
ContactBasis<dim>::add_board(const BoardContacts<dim> &board)
{
  for (auto &vector : board.vectors())
    all_vectors.push_back(std::move(vector));
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
            return aside_at(pair.normal, edge);
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
void
ContactBasis<dim>::add_outer_hats(const std::vector<EntryHat<dim>> &outer,
                                  const BladeEdge<dim> &edge)
{
  for (const auto &entry : outer)
    {
      const double area = entry.hat.area;
      all_hats.push_back({0, area, entry.depth, area, {}, entry});
      const Tensor<1, dim> out = entry.is_plus ? edge.normal : -edge.normal;
      std::vector<Tensor<1, dim>> ways = {out, edge.direction};
      if (blade.sliding.rubs_aside())
        ways.push_back(aside_at(edge.normal, edge));
      for (const auto &way : ways)
        {
          UnknownForces vector;
          for (const auto &[node, weight] : entry.hat.nodes)
            for (unsigned int c = 0; c < dim; ++c)
              vector.emplace_back(node[c], weight * way[c]);
          all_vectors.push_back(vector);
        }
    }
}



template <int dim>
unsigned int
ContactBasis<dim>::vector_of_hat(const unsigned int hat,
                                 const Wall wall,
                                 const Component component) const
{
  return first_vector_of_hat(hat) +
         (wall == Wall::plus && !all_hats[hat].outer ? n_vectors_of_wall()
                                                     : 0) +
         static_cast<unsigned int>(component);
}



template <int dim>
unsigned int
ContactBasis<dim>::vector_of_edge_node(const unsigned int node) const
{
  return first_vector_of_hat(all_hats.size()) + (edge_holds() ? 2 : 1) * node;
}



template <int dim>
unsigned int
ContactBasis<dim>::first_vector_of_hat(const unsigned int hat) const
{
  if (!has_flanks())
    return hat;
  // On the cut a hat is of two walls.
  return n_vectors_of_wall() * (hat + std::min(hat, n_hats_on_cut));
}



template <int dim>
std::vector<unsigned int>
ContactBasis<dim>::vectors_of_stage(const unsigned int n_split,
                                    const unsigned int n_ahead) const
{
  std::vector<unsigned int> vectors;
  for (unsigned int h = 0; h < all_hats.size(); ++h)
    if (all_hats[h].is_there(n_split + n_ahead))
      for (unsigned int v = first_vector_of_hat(h);
           v < first_vector_of_hat(h + 1);
           ++v)
        vectors.push_back(v);
  for (unsigned int n = 0; n < all_edge_nodes.size(); ++n)
    if (all_edge_nodes[n].row == n_split)
      for (unsigned int v = vector_of_edge_node(n);
           v < vector_of_edge_node(n + 1);
           ++v)
        vectors.push_back(v);
  for (unsigned int v = first_vector_of_earlier_corners();
       v < all_vectors.size();
       ++v)
    vectors.push_back(v);
  return vectors;
}



template class ContactBasis<2>;
template class ContactBasis<3>;
} // namespace Setsudan
