// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/partitioner.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <vector>

namespace Setsudan
{
/** Homogeneous constraints for vectors of one partition, in the places of their
 * unknowns there. */
class LocalConstraints
{
public:
  using Vector      = dealii::LinearAlgebra::distributed::Vector<double>;
  using Partitioner = dealii::Utilities::MPI::Partitioner;

  /** @param constraints closed; the partition has all that they name. */
  LocalConstraints(const dealii::AffineConstraints<double> &constraints,
                   const Partitioner &partitioner);

  /**
   * Evaluate the constraints: set constrained entries; all others, ghosts too,
   * must be up to date.
   */
  void
  distribute(Vector &vector) const;

  /** The transpose: hand forces on constrained unknowns to those which they
   * depend on, not yet to their owners. */
  void
  condense(Vector &forces) const;

  /** The same with squares of the weights, as a diagonal needs. */
  void
  condense_diagonal(Vector &diagonal) const;

  bool
  is_constrained(const unsigned int place) const;

  /** The places of this process's own that are constrained. */
  const std::vector<unsigned int> &
  owned() const;

private:
  struct Entry
  {
    unsigned int place;
    double weight;
  };

  /** @param power of the weights. */
  void
  hand_over(Vector &forces, const unsigned int power) const;

  std::vector<unsigned int> places;
  /** Where the entries of each line begin, and the last one's end. */
  std::vector<unsigned int> starts;
  std::vector<Entry> entries;
  std::vector<unsigned int> owned_places;
  std::vector<bool> is_line;
};
} // namespace Setsudan
