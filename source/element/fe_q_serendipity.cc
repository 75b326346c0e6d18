// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/element/fe_q_serendipity.h>
#include <setsudan/element/serendipity_polynomials.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/geometry_info.h>

#include <deal.II/fe/component_mask.h>
#include <deal.II/fe/fe_data.h>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** One unknown for each vertex and line, none for quadrilaterals and hexahedra.
 */
template <int dim>
std::vector<unsigned int>
dofs_per_object()
{
  std::vector<unsigned int> n_dofs(dim + 1, 0);
  n_dofs[0] = n_dofs[1] = 1;
  return n_dofs;
}


template <int dim>
bool
is_serendipity(const FiniteElement<dim> &fe)
{
  return dynamic_cast<const FE_Q_Serendipity<dim> *>(&fe) != nullptr;
}


/** The unknowns that are the same on an object that two elements share, where
 * each has one unknown there. */
template <int dim>
std::vector<std::pair<unsigned int, unsigned int>>
shared_dof(const FiniteElement<dim> &fe_other)
{
  if (is_serendipity(fe_other))
    return {{0U, 0U}};
  Assert(false, ExcNotImplemented());
  return {};
}


/** The functions of @p polynomials at @p points, a row for each point. */
template <int dim>
void
fill_interpolation_matrix(const SerendipityPolynomials<dim> &polynomials,
                          const std::vector<Point<dim>> &points,
                          FullMatrix<double> &matrix)
{
  AssertDimension(matrix.m(), points.size());
  AssertDimension(matrix.n(), polynomials.n());
  for (unsigned int i = 0; i < points.size(); ++i)
    for (unsigned int j = 0; j < polynomials.n(); ++j)
      matrix(i, j) = polynomials.compute_value(j, points[i]);
}
} // namespace


template <int dim>
FE_Q_Serendipity<dim>::FE_Q_Serendipity()
  : FE_Poly<dim>(
      SerendipityPolynomials<dim>(),
      FiniteElementData<dim>(dofs_per_object<dim>(),
                             1,
                             2,
                             FiniteElementData<dim>::H1),
      // The restriction is injection: a node that several children
      // share has the same value in each of them, which is not to
      // be added up.
      std::vector<bool>(SerendipityPolynomials<dim>::nodes().size(), false),
      std::vector<ComponentMask>(SerendipityPolynomials<dim>::nodes().size(),
                                 ComponentMask(1, true)))
{
  this->unit_support_points = SerendipityPolynomials<dim>::nodes();
  // The unknowns of a face are those of its vertices and lines, so that its
  // functions are the serendipity polynomials of one dimension less.
  this->unit_face_support_points.resize(1);
  this->unit_face_support_points[0] = SerendipityPolynomials<dim - 1>::nodes();
  initialize_embedding_and_restriction();
}


template <int dim>
void
FE_Q_Serendipity<dim>::initialize_embedding_and_restriction()
{
  const SerendipityPolynomials<dim> polynomials;
  const std::vector<Point<dim>> nodes = polynomials.nodes();

  this->reinit_restriction_and_prolongation_matrices(true, true);
  constexpr unsigned int isotropic =
    RefinementCase<dim>::isotropic_refinement - 1;
  for (unsigned int child = 0; child < GeometryInfo<dim>::max_children_per_cell;
       ++child)
    {
      std::vector<Point<dim>> child_nodes;
      for (const Point<dim> &node : nodes)
        child_nodes.push_back(
          GeometryInfo<dim>::child_to_cell_coordinates(node, child));
      fill_interpolation_matrix(
        polynomials, child_nodes, this->prolongation[isotropic][child]);

      // Each node of the cell is a vertex of the children that touch it.
      FullMatrix<double> &restriction = this->restriction[isotropic][child];
      for (unsigned int i = 0; i < nodes.size(); ++i)
        for (unsigned int j = 0; j < nodes.size(); ++j)
          restriction(i, j) = child_nodes[j] == nodes[i] ? 1. : 0.;
    }
}


template <int dim>
std::string
FE_Q_Serendipity<dim>::get_name() const
{
  return "FE_Q_Serendipity<" + std::to_string(dim) + ">()";
}


template <int dim>
std::unique_ptr<FiniteElement<dim>>
FE_Q_Serendipity<dim>::clone() const
{
  return std::make_unique<FE_Q_Serendipity<dim>>(*this);
}


template <int dim>
std::pair<Table<2, bool>, std::vector<unsigned int>>
FE_Q_Serendipity<dim>::get_constant_modes() const
{
  Table<2, bool> constant_modes(1, this->n_dofs_per_cell());
  constant_modes.fill(true);
  return {constant_modes, {0U}};
}


template <int dim>
bool
FE_Q_Serendipity<dim>::has_support_on_face(const unsigned int shape_index,
                                           const unsigned int face_index) const
{
  AssertIndexRange(shape_index, this->n_dofs_per_cell());
  AssertIndexRange(face_index, GeometryInfo<dim>::faces_per_cell);
  // Faces 2d and 2d+1 lie at coordinate d equal to 0 and 1.
  return this->unit_support_points[shape_index][face_index / 2] ==
         face_index % 2;
}


template <int dim>
void
FE_Q_Serendipity<dim>::convert_generalized_support_point_values_to_dof_values(
  const std::vector<Vector<double>> &support_point_values,
  std::vector<double> &nodal_values) const
{
  AssertDimension(support_point_values.size(), this->n_dofs_per_cell());
  AssertDimension(nodal_values.size(), this->n_dofs_per_cell());
  for (unsigned int i = 0; i < nodal_values.size(); ++i)
    {
      AssertDimension(support_point_values[i].size(), 1);
      nodal_values[i] = support_point_values[i](0);
    }
}


template <int dim>
bool
FE_Q_Serendipity<dim>::hp_constraints_are_implemented() const
{
  return true;
}


template <int dim>
void
FE_Q_Serendipity<dim>::get_face_interpolation_matrix(
  const FiniteElement<dim> &source,
  FullMatrix<double> &interpolation_matrix,
  const unsigned int face_no) const
{
  AssertThrow(is_serendipity(source),
              typename FiniteElement<dim>::ExcInterpolationNotImplemented());
  fill_interpolation_matrix(SerendipityPolynomials<dim - 1>(),
                            source.get_unit_face_support_points(face_no),
                            interpolation_matrix);
}


template <int dim>
void
FE_Q_Serendipity<dim>::get_subface_interpolation_matrix(
  const FiniteElement<dim> &source,
  const unsigned int subface,
  FullMatrix<double> &interpolation_matrix,
  const unsigned int face_no) const
{
  AssertThrow(is_serendipity(source),
              typename FiniteElement<dim>::ExcInterpolationNotImplemented());
  std::vector<Point<dim - 1>> points;
  for (const Point<dim - 1> &node :
       source.get_unit_face_support_points(face_no))
    points.push_back(
      GeometryInfo<dim - 1>::child_to_cell_coordinates(node, subface));
  fill_interpolation_matrix(
    SerendipityPolynomials<dim - 1>(), points, interpolation_matrix);
}


template <int dim>
std::vector<std::pair<unsigned int, unsigned int>>
FE_Q_Serendipity<dim>::hp_vertex_dof_identities(
  const FiniteElement<dim> &fe_other) const
{
  return shared_dof(fe_other);
}


template <int dim>
std::vector<std::pair<unsigned int, unsigned int>>
FE_Q_Serendipity<dim>::hp_line_dof_identities(
  const FiniteElement<dim> &fe_other) const
{
  return shared_dof(fe_other);
}


template <int dim>
std::vector<std::pair<unsigned int, unsigned int>>
FE_Q_Serendipity<dim>::hp_quad_dof_identities(
  const FiniteElement<dim> & /*fe_other*/,
  const unsigned int /*face_no*/) const
{
  return {};
}


template <int dim>
FiniteElementDomination::Domination
FE_Q_Serendipity<dim>::compare_for_domination(
  const FiniteElement<dim> &fe_other,
  const unsigned int codim) const
{
  (void)codim;
  AssertIndexRange(codim, dim + 1);
  if (is_serendipity(fe_other))
    return FiniteElementDomination::either_element_can_dominate;
  Assert(false, ExcNotImplemented());
  return FiniteElementDomination::neither_element_dominates;
}


template class FE_Q_Serendipity<2>;
template class FE_Q_Serendipity<3>;
} // namespace Setsudan
