#include <deal.II/base/qprojector.h>
#include <deal.II/base/quadrature_lib.h>

#include <setsudan/body/geometry.h>
#include <setsudan/cut/row_areas.h>

#include <algorithm>
#include <limits>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** A rule for faces that is repeated within the halves of the refined cells'
 * faces, between which the rows of corner and mid-side nodes lie. */
template <int dim>
Quadrature<dim>
rule_on_face(const unsigned int face, const unsigned int n_levels)
{
  return QProjector<dim>::project_to_face(
    ReferenceCells::get_hypercube<dim>(),
    QIterated<dim - 1>(QGauss<1>(2), 1u << (n_levels + 1)),
    face);
}
} // namespace


template <int dim>
std::vector<RowArea>
row_areas(const Body<dim> &body,
          const MaterialParameters<dim> &materials,
          const CutSurface<dim> &surface,
          const BladeEdge<dim> &edge,
          const std::vector<Row> &rows,
          const unsigned int n_levels)
{
  std::vector<Quadrature<dim>> rules;
  for (unsigned int f = 0; f < GeometryInfo<dim>::faces_per_cell; ++f)
    rules.push_back(rule_on_face<dim>(f, n_levels));

  double entry = std::numeric_limits<double>::max();
  for (const auto &face : surface)
    for (unsigned int node = 0; node < n_element_nodes<dim>; ++node)
      if (node_is_on_face<dim>(node, face.minus.second))
        entry = std::min(
          entry, edge.travel(body.mesh.node_position(face.minus.first, node)));

  std::vector<RowArea> areas(rows.size());
  for (const auto &face : surface)
    {
      const auto &[cell, f] = face.minus;
      const auto nodes      = body.mesh.node_positions(cell);
      const double toughness =
        std::min(materials.of_element(cell).toughness,
                 materials.of_element(face.plus.first).toughness);
      for (unsigned int q = 0; q < rules[f].size(); ++q)
        {
          const auto &unit_point = rules[f].point(q);
          const double area =
            rules[f].weight(q) * area_element_of_face(nodes, f, unit_point);
          const double depth =
            edge.travel(point_of_element(nodes, unit_point)) - entry;
          const auto next = std::upper_bound(
            rows.begin(),
            rows.end(),
            depth,
            [](const double d, const Row &row) { return d < row.depth; });
          RowArea &of_row =
            areas[std::max<std::ptrdiff_t>(next - rows.begin() - 1, 0)];
          of_row.area += area;
          of_row.energy += area * toughness;
        }
    }
  return areas;
}



template std::vector<RowArea>
row_areas(const Body<2> &,
          const MaterialParameters<2> &,
          const CutSurface<2> &,
          const BladeEdge<2> &,
          const std::vector<Row> &,
          const unsigned int);
template std::vector<RowArea>
row_areas(const Body<3> &,
          const MaterialParameters<3> &,
          const CutSurface<3> &,
          const BladeEdge<3> &,
          const std::vector<Row> &,
          const unsigned int);
} // namespace Setsudan
