// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <setsudan/contact/face_hats.h>
#include <setsudan/mesh/face_index.h>
#include <setsudan/mesh/geometry.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>

#include <algorithm>
#include <map>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** A hat, as far as a process knows it. */
template <int dim>
struct PartOfHat
{
  using NodeIndices = typename Discretization<dim>::NodeIndices;

  unsigned int element = numbers::invalid_unsigned_int;
  double area          = 0;
  /** The integral of position times hat. */
  Tensor<1, dim> moment;
  std::map<NodeIndices, double> weights;

  void
  add(const PartOfHat &other)
  {
    element = std::min(element, other.element);
    area += other.area;
    moment += other.moment;
    for (const auto &[node, weight] : other.weights)
      weights[node] += weight;
  }

  template <typename Archive>
  void
  serialize(Archive &archive, const unsigned int)
  {
    archive &element &area &moment &weights;
  }
};

template <int dim>
using PartsOfHats =
  std::map<typename Discretization<dim>::NodeIndices, PartOfHat<dim>>;



/** Integrates hats over the faces of cells. */
template <int dim>
class HatIntegrator
{
public:
  explicit HatIntegrator(const ElasticModel<dim> &model)
    : discretization(model.discretization)
    , hanging(model.hanging)
    , linear(1)
    , gauss(discretization.n_gauss_points())
    , hats(discretization.mapping(), linear, gauss, update_values)
    , shapes(discretization.mapping(),
             discretization.fe.base_element(0),
             gauss,
             update_values | update_JxW_values)
  {
  }

  void
  add(const typename Discretization<dim>::Cell &cell, const unsigned int face)
  {
    const typename Triangulation<dim>::cell_iterator in_mesh = cell;
    hats.reinit(in_mesh, face);
    shapes.reinit(in_mesh, face);
    const auto nodes     = discretization.node_indices(cell);
    const auto positions = discretization.node_positions(cell);
    const auto &units    = discretization.nodes();
    for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
      {
        if (GeometryInfo<dim>::unit_cell_vertex(v)[face / 2] != face % 2)
          continue;
        // The first nodes of a cell are its vertices.
        auto &hat   = parts[nodes[v]];
        hat.element = std::min(hat.element, discretization.element(cell));
        for (unsigned int k = 0; k < nodes.size(); ++k)
          if (units[k][face / 2] == face % 2)
            {
              double weight = 0;
              for (const unsigned int q : shapes.quadrature_point_indices())
                weight += hats.shape_value(v, q) * shapes.shape_value(k, q) *
                          shapes.JxW(q);
              hat.area += weight;
              hat.moment += weight * positions[k];
              add(nodes[k], weight, hat);
            }
      }
  }

  PartsOfHats<dim> parts;

private:
  /** A node's weight, or the weights of those between which it hangs. */
  void
  add(const typename Discretization<dim>::NodeIndices &node,
      const double weight,
      PartOfHat<dim> &hat) const
  {
    if (!hanging.is_constrained(node[0]))
      {
        hat.weights[node] += weight;
        return;
      }
    // All components hang between the same nodes, in the same order.
    const auto &between = *hanging.get_constraint_entries(node[0]);
    for (unsigned int i = 0; i < between.size(); ++i)
      {
        typename Discretization<dim>::NodeIndices other;
        for (unsigned int c = 0; c < dim; ++c)
          other[c] = (*hanging.get_constraint_entries(node[c]))[i].first;
        hat.weights[other] += weight * between[i].second;
      }
  }

  const Discretization<dim> &discretization;
  const AffineConstraints<double> &hanging;
  const FE_Q<dim> linear;
  const QGauss<dim - 1> gauss;
  FEFaceValues<dim> hats, shapes;
};



/** A corner on the border between processes has faces on several. */
template <int dim>
PartsOfHats<dim>
sum_over_processes(const PartsOfHats<dim> &parts, const MPI_Comm communicator)
{
  PartsOfHats<dim> sum;
  for (const auto &of_process : Utilities::MPI::all_gather(communicator, parts))
    for (const auto &[corner, part] : of_process)
      sum[corner].add(part);
  return sum;
}
} // namespace


template <int dim>
std::vector<FaceHat<dim>>
face_hats(const ElasticModel<dim> &model, const std::vector<CellFace> &faces)
{
  std::multimap<unsigned int, unsigned int> faces_of_element(faces.begin(),
                                                             faces.end());
  HatIntegrator<dim> integrator(model);
  const auto &discretization = model.discretization;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    {
      if (!cell->is_locally_owned())
        continue;
      const auto range =
        faces_of_element.equal_range(discretization.element(cell));
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
  std::vector<FaceHat<dim>> hats;
  for (const auto &[corner, part] :
       sum_over_processes<dim>(integrator.parts, discretization.communicator))
    hats.push_back({corner,
                    part.element,
                    part.area,
                    Point<dim>(part.moment / part.area),
                    {part.weights.begin(), part.weights.end()}});
  return hats;
}



template <int dim>
std::vector<CellFace>
outer_faces_against(const CoarseMesh<dim> &mesh,
                    const Tensor<1, dim> &direction,
                    const double least_cosine)
{
  std::vector<CellFace> faces;
  const FaceIndex<dim> index(mesh);
  for (const auto &[key, face] : index.faces())
    {
      if (index.find(key).size() > 1)
        continue;
      const Tensor<1, dim> area =
        area_vector_of_face<dim>(mesh.node_positions(face.first), face.second);
      if (area * direction <= -least_cosine * area.norm())
        faces.push_back(face);
    }
  return faces;
}



template std::vector<CellFace>
outer_faces_against(const CoarseMesh<2> &, const Tensor<1, 2> &, const double);
template std::vector<CellFace>
outer_faces_against(const CoarseMesh<3> &, const Tensor<1, 3> &, const double);
template std::vector<FaceHat<2>>
face_hats(const ElasticModel<2> &, const std::vector<CellFace> &);
template std::vector<FaceHat<3>>
face_hats(const ElasticModel<3> &, const std::vector<CellFace> &);
} // namespace Setsudan
