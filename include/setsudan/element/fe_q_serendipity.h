// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/table.h>

#include <deal.II/fe/fe_poly.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Setsudan
{
/**
 * The quadratic serendipity element: continuous, with one degree of freedom on
 * each vertex and each line, 8 in 2D and 20 in 3D. It is the element of
 * Kakefuda et al. (1996), equations (1) and (2); see Zienkiewicz and Taylor,
 * The Finite Element Method, on the serendipity family. The functions are
 * SerendipityPolynomials. On a parallelepiped the space holds all quadratic
 * polynomials; on a cell with straight lines that is no parallelepiped it
 * holds the linear ones.
 *
 * Hanging nodes are constrained by the way that deal.II has for hp elements,
 * get_subface_interpolation_matrix(), and by that one only. The older way, the
 * table FiniteElement::interface_constraints, counts unknowns inside of the
 * faces, of which this element has none, and it gives wrong constraints where
 * refined neighbours belong to another process.
 */
template <int dim>
class FE_Q_Serendipity : public dealii::FE_Poly<dim>
{
public:
  /** Set up the element; there is nothing to choose. */
  FE_Q_Serendipity();

  /** "FE_Q_Serendipity<dim>()". */
  std::string
  get_name() const override;

  /** A copy of this object. */
  std::unique_ptr<dealii::FiniteElement<dim>>
  clone() const override;

  /** One constant mode, in which all degrees of freedom are equal. */
  std::pair<dealii::Table<2, bool>, std::vector<unsigned int>>
  get_constant_modes() const override;

  /** Whether function @p shape_index is non-zero somewhere on the face: true
   * for the functions whose node lies on it. */
  bool
  has_support_on_face(const unsigned int shape_index,
                      const unsigned int face_index) const override;

  /** The degrees of freedom are the values at the support points. */
  void
  convert_generalized_support_point_values_to_dof_values(
    const std::vector<dealii::Vector<double>> &support_point_values,
    std::vector<double> &nodal_values) const override;

  /** True, see the description of the class. */
  bool
  hp_constraints_are_implemented() const override;

  /**
   * The face functions of this element at the face nodes of @p source, which
   * must be a serendipity element too, so that this is the identity.
   */
  void
  get_face_interpolation_matrix(
    const dealii::FiniteElement<dim> &source,
    dealii::FullMatrix<double> &interpolation_matrix,
    const unsigned int face_no = 0) const override;

  /**
   * The face functions of this element, on the coarse side, at the face nodes
   * of @p source, a serendipity element on child @p subface of the face. A
   * row constrains a node of the refined side.
   */
  void
  get_subface_interpolation_matrix(
    const dealii::FiniteElement<dim> &source,
    const unsigned int subface,
    dealii::FullMatrix<double> &interpolation_matrix,
    const unsigned int face_no = 0) const override;

  /** The one unknown of a vertex is shared with a serendipity element. */
  std::vector<std::pair<unsigned int, unsigned int>>
  hp_vertex_dof_identities(
    const dealii::FiniteElement<dim> &fe_other) const override;

  /** The one unknown of a line is shared with a serendipity element. */
  std::vector<std::pair<unsigned int, unsigned int>>
  hp_line_dof_identities(
    const dealii::FiniteElement<dim> &fe_other) const override;

  /** None: there are no unknowns inside of quadrilaterals. */
  std::vector<std::pair<unsigned int, unsigned int>>
  hp_quad_dof_identities(const dealii::FiniteElement<dim> &fe_other,
                         const unsigned int face_no = 0) const override;

  /** Serendipity elements have the same trace on a common face; any other
   * neighbour is not implemented. */
  dealii::FiniteElementDomination::Domination
  compare_for_domination(const dealii::FiniteElement<dim> &fe_other,
                         const unsigned int codim = 0) const override;

private:
  /** Compute the nodal interpolation from a cell to its children, and back. */
  void
  initialize_embedding_and_restriction();
};
} // namespace Setsudan
