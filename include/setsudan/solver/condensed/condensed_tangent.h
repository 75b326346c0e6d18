// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/solver/condensed/static_condensation.h>
#include <setsudan/solver/condensed/symmetric_factor.h>
#include <setsudan/solver/condensed/unknown_forces.h>

#include <memory>
#include <vector>

namespace Setsudan
{
/**
 * The tangent of a body about one displacement after another, condensed onto
 * the unknowns on which some forces act: what these forces do to each other
 * costs no solve for each.
 *
 * The rest of the body must be stable where these unknowns are held; whether it
 * is where they are free, the condensed tangent tells. Of several processes the
 * first one has it; the others wait.
 */
template <int dim>
class CondensedTangent
{
public:
  /**
   * @param constraints homogeneous and closed; must live as long.
   * @param forces, springs the same on all processes. The springs are stiffness
   *   beside that of the body, v v^T for each v.
   */
  CondensedTangent(const ElasticModel<dim> &model,
                   const dealii::AffineConstraints<double> &constraints,
                   const std::vector<UnknownForces> &forces,
                   const std::vector<UnknownForces> &springs);

  /** Take the tangent about a displacement without ghosts.
   *
   * @param shift what is added to its diagonal, in relation to the mean of
   *   that.
   * @throw NotDefiniteError where the rest of the body is not stable. */
  void
  linearize(const LA::Vector &displacement, const double shift = 0);

  /** How many eigenvalues of the tangent are negative. */
  unsigned int
  n_negative() const
  {
    return n_negative_ones;
  }

  /** The work of one force in the displacement under another, for all of them.
   */
  dealii::LAPACKFullMatrix<double>
  products() const;

  /** The displacement under a residual that is not condensed, without iterative
   * refinement. */
  LA::Vector
  increment(const LA::Vector &residual) const;

  /** See round_off_of_forces(). */
  double
  round_off() const;

private:
  /** Forces as the constraints hand them on to free unknowns, on all processes.
   */
  std::vector<UnknownForces>
  condensed(const std::vector<UnknownForces> &forces) const;

  /** By the places of unknowns on the interface. */
  std::vector<UnknownForces>
  placed(std::vector<UnknownForces> forces) const;

  /** Factor a matrix of the first process. */
  void
  factorize(const LA::SparseMatrix &whole);

  const ElasticModel<dim> &model;
  const dealii::AffineConstraints<double> &constraints;
  const MPI_Comm communicator;
  const bool is_first;
  /** The unknowns on which they act, ascending; below forces have places among
   * them. */
  std::vector<unsigned int> interface;
  std::vector<UnknownForces> forces;
  std::vector<UnknownForces> springs;
  LA::SparseMatrix matrix;
  /** On the first process. */
  std::unique_ptr<StaticCondensation> condensation;
  std::unique_ptr<SymmetricFactor> factor;
  unsigned int n_negative_ones = 0;
};
} // namespace Setsudan
