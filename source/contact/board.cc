// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/contact/board.h>
#include <setsudan/parameters/lists.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** How far from the board a face may be that comes to lie on it, as a part of
 * the body's height above it. */
constexpr double reach = 0.05;

constexpr double default_friction = 0.5;

/** What is nearer to the board than this part of the body's extent lies on it.
 */
constexpr double touch = 1e-6;

} // namespace


template <int dim>
void
BoardParameters<dim>::declare(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Board",
                    "Plane",
                    "",
                    Patterns::Anything(),
                    "A rigid plane that the body lies on, without being glued "
                    "to it: a point and the normal towards the body, as "
                    "'0,0,0; 0,0,1'. Empty: no board.");
  Setsudan::declare(handler,
                    "Board",
                    "Friction",
                    short_text(default_friction),
                    Patterns::Double(0),
                    "Coulomb's coefficient between board and body.");
}



template <int dim>
BoardParameters<dim>::BoardParameters(const Parameters &parameters,
                                      const Body<dim> &body)
  : is_given(!parameters.text("Board", "Plane").empty())
  , friction(parameters.number("Board", "Friction"))
{
  // A run's own parameters name it with its default.
  parameters.require(is_given || friction == default_friction,
                     "Board",
                     "Plane",
                     "a point and a normal where Board/Friction is given");
  if (!is_given)
    return;
  read_plane(parameters);
  double nearest = std::numeric_limits<double>::max();
  for (unsigned int cell = 0; cell < body.mesh.cells.size(); ++cell)
    for (const auto &node : body.mesh.node_positions(cell))
      nearest = std::min(nearest, distance(node));
  const double tolerance = touch * body.mesh.extent();
  parameters.require(nearest >= -tolerance,
                     "Board",
                     "Plane",
                     "a plane that does not cut through the body, which "
                     "reaches " +
                       short_text(-nearest) +
                       " beyond this one, with a normal towards the body");
  parameters.require(nearest <= tolerance,
                     "Board",
                     "Plane",
                     "a plane that touches the body, which is " +
                       short_text(nearest) + " above this one");
  find_faces(body);
}



template <int dim>
void
BoardParameters<dim>::read_plane(const Parameters &parameters)
{
  const auto parts = split(parameters.text("Board", "Plane"), ';');
  std::array<std::vector<double>, 2> values;
  bool is_right = parts.size() == 2;
  for (unsigned int i = 0; i < 2 && is_right; ++i)
    is_right = parse_numbers(parts[i], values[i]) && values[i].size() == dim;
  for (unsigned int c = 0; c < dim && is_right; ++c)
    {
      point[c]  = values[0][c];
      normal[c] = values[1][c];
    }
  parameters.require(is_right && normal.norm() > 0,
                     "Board",
                     "Plane",
                     std::string("a point and a normal that is not 0, as ") +
                       (dim == 3 ? "'0,0,0; 0,0,1'" : "'0,0; 0,1'"));
  normal /= normal.norm();
}



template <int dim>
void
BoardParameters<dim>::find_faces(const Body<dim> &body)
{
  const auto &mesh = body.mesh;
  double height    = 0;
  for (const auto &vertex : mesh.vertices)
    height = std::max(height, distance(vertex));
  for (const auto &face : outer_faces_against(mesh, normal))
    {
      double nearest = std::numeric_limits<double>::max();
      for (const unsigned int vertex : mesh.face_vertices(face))
        nearest = std::min(nearest, distance(mesh.vertices[vertex]));
      if (nearest <= reach * height)
        faces.push_back(face);
    }
}



template <int dim>
BoardContacts<dim>::BoardContacts(const ElasticModel<dim> &model,
                                  const BoardParameters<dim> &board,
                                  const double stiffness,
                                  const double extent)
  : friction(board.friction)
{
  all_directions[0] = board.normal;
  // An axis that is far from the normal.
  unsigned int axis = 0;
  for (unsigned int c = 1; c < dim; ++c)
    if (std::abs(board.normal[c]) < std::abs(board.normal[axis]))
      axis = c;
  Tensor<1, dim> along;
  along[axis] = 1;
  along -= (along * board.normal) * board.normal;
  all_directions[1] = along / along.norm();
  if constexpr (dim == 3)
    all_directions[2] = cross_product_3d(board.normal, all_directions[1]);
  for (const auto &hat : face_hats(model, board.faces))
    all_corners.push_back(
      {hat, board.distance(hat.center), stiffness / (extent * hat.area), true});
  mark_supported(model);
}



template <int dim>
void
BoardContacts<dim>::mark_supported(const ElasticModel<dim> &model)
{
  const auto all = vectors();
  std::vector<unsigned int> moves;
  for (unsigned int corner = 0; corner < all_corners.size(); ++corner)
    moves.push_back(std::any_of(
      all[dim * corner].begin(), all[dim * corner].end(), [&](const auto &of) {
        return model.discretization.owned.is_element(of.first) &&
               !model.supports.is_constrained(of.first);
      }));
  Utilities::MPI::max(moves, model.discretization.communicator, moves);
  for (unsigned int corner = 0; corner < all_corners.size(); ++corner)
    all_corners[corner].moves = moves[corner] == 1;
}



template <int dim>
std::vector<UnknownForces>
BoardContacts<dim>::vectors() const
{
  std::vector<UnknownForces> all;
  for (const auto &corner : all_corners)
    for (const auto &direction : all_directions)
      {
        UnknownForces vector;
        for (const auto &[node, weight] : corner.hat.nodes)
          for (unsigned int c = 0; c < dim; ++c)
            if (direction[c] != 0)
              vector.emplace_back(node[c], weight * direction[c]);
        all.push_back(vector);
      }
  return all;
}



template <int dim>
std::vector<UnknownForces>
BoardContacts<dim>::springs() const
{
  std::vector<UnknownForces> springs;
  auto all = vectors();
  for (unsigned int i = 0; i < all.size(); ++i)
    {
      const auto &corner = all_corners[i / dim];
      // No condition takes the others out again.
      if (!corner.moves)
        continue;
      for (auto &[unknown, factor] : all[i])
        factor *= std::sqrt(corner.stiffness);
      springs.push_back(std::move(all[i]));
    }
  return springs;
}



template <int dim>
double
travel_to_board(const BoardParameters<dim> &board,
                const CoarseMesh<dim> &mesh,
                const Cut<dim> &cut)
{
  const double approach = -(cut.edge.direction * board.normal);
  // Less is round-off of a direction along the board.
  if (!board.is_given || approach < 1e-10)
    return std::numeric_limits<double>::infinity();
  double entry  = std::numeric_limits<double>::max();
  double travel = entry;
  for (const auto &[vertex, to_vertex] : travels_to_vertices(mesh, cut))
    {
      entry  = std::min(entry, to_vertex);
      travel = std::min(
        travel, to_vertex + board.distance(mesh.vertices[vertex]) / approach);
    }
  return travel - entry;
}



template <int dim>
double
last_travel_on_board(const BoardParameters<dim> &board,
                     const CoarseMesh<dim> &mesh,
                     const Cut<dim> &cut)
{
  return 1.01 * travel_to_board(board, mesh, cut);
}



template <int dim>
bool
carries_something(const BoardContacts<dim> &board)
{
  return std::any_of(board.corners().begin(),
                     board.corners().end(),
                     [](const auto &corner) { return corner.moves; });
}



template <int dim>
double
depth_beyond_board(const ElasticModel<dim> &model,
                   const BoardParameters<dim> &board,
                   const LA::Vector &displacement)
{
  const auto &discretization = model.discretization;
  const LA::Vector known     = discretization.with_ghosts(displacement);
  double depth               = 0;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    {
      if (!cell->is_locally_owned())
        continue;
      const auto nodes     = discretization.node_indices(cell);
      const auto positions = discretization.node_positions(cell);
      for (unsigned int n = 0; n < nodes.size(); ++n)
        {
          double distance = board.distance(positions[n]);
          for (unsigned int c = 0; c < dim; ++c)
            distance += known(nodes[n][c]) * board.normal[c];
          depth = std::max(depth, -distance);
        }
    }
  return Utilities::MPI::max(depth, discretization.communicator);
}



#define INSTANTIATE(dim)                                                      \
  template double travel_to_board(                                            \
    const BoardParameters<dim> &, const CoarseMesh<dim> &, const Cut<dim> &); \
  template double last_travel_on_board(                                       \
    const BoardParameters<dim> &, const CoarseMesh<dim> &, const Cut<dim> &); \
  template bool carries_something(const BoardContacts<dim> &);                \
  template double depth_beyond_board(const ElasticModel<dim> &,               \
                                     const BoardParameters<dim> &,            \
                                     const LA::Vector &);                     \
  template struct BoardParameters<dim>;                                       \
  template class BoardContacts<dim>;

INSTANTIATE(2)
INSTANTIATE(3)

#undef INSTANTIATE
} // namespace Setsudan
