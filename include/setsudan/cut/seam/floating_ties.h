#pragma once

#include <setsudan/cut/seam/seam.h>
#include <setsudan/mechanics/pieces/piece_motions.h>

#include <vector>

namespace Setsudan
{
/**
 * Refuse to go on where the blade presses on a loose group of pieces.
 *
 * @param pieces    the piece of every element behind the surgery.
 * @param direction of the blade.
 * @throw std::runtime_error where a pair is still tied that the group does not
 * hold against the blade.
 */
template <int dim>
void
check_ties_of_loose_group(const Seam<dim> &seam,
                          const std::vector<unsigned int> &pieces,
                          const FloatingGroup<dim> &group,
                          const dealii::Tensor<1, dim> &direction);
} // namespace Setsudan
