// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/solver/condensed/connected_components.h>
#include <setsudan/solver/condensed/static_condensation.h>

#include <algorithm>
#include <iterator>

namespace Setsudan
{
namespace
{
/** A shift that makes even a body definite that only its cut holds: of the size
 * of the stiffness there, so that taking it off again loses no digits. */
double
shift_of(const LA::SparseMatrix &matrix, const std::vector<unsigned int> &cut)
{
  double sum = 0;
  for (const unsigned int unknown : cut)
    sum += matrix.diag_element(unknown);
  return cut.empty() ? 0 : sum / cut.size();
}



/** Whether parts are so alike that each is best left to one core: the largest
 * takes about as the square of its size. */
bool
are_alike(const std::vector<std::vector<unsigned int>> &parts)
{
  constexpr double largest_share = 0.6;
  std::size_t largest = 0, all = 0;
  for (const auto &part : parts)
    {
      largest = std::max(largest, part.size());
      all += part.size();
    }
  return largest <= largest_share * all;
}



void
for_each_part(const unsigned int n_parts,
              const bool at_once,
              const std::function<void(unsigned int)> &work)
{
  // One part alone leaves all cores to the BLAS.
  if (at_once && n_parts > 1)
    parallel_for(n_parts, work);
  else
    for (unsigned int part = 0; part < n_parts; ++part)
      work(part);
}
} // namespace


StaticCondensation::StaticCondensation(const LA::SparseMatrix &matrix,
                                       const std::vector<unsigned int> &cut)
  : cut(cut)
{
  // Below this a thread takes longer to begin than to work.
  constexpr double many_entries = 2e6;
  const double shift            = shift_of(matrix, cut);
  const auto unknowns           = connected_components(matrix);
  parts.resize(unknowns.size());
  parts_are_alike = are_alike(unknowns);
  take_blocks([&](const unsigned int p) {
    return factorize(matrix, unknowns[p], shift, parts[p]);
  });
  double n_entries = 0;
  for (const auto &part : parts)
    n_entries += part.factor->n_entries();
  is_large = n_entries > many_entries;
}



void
StaticCondensation::update(const LA::SparseMatrix &matrix)
{
  const double shift = shift_of(matrix, cut);
  take_blocks([&](const unsigned int p) {
    parts[p].factor->update(matrix, shift);
    return SchurComplement::square(
      parts[p].of_cut, parts[p].factor->last_block(), shift);
  });
}



void
StaticCondensation::take_blocks(
  const std::function<SchurComplement::Block(unsigned int)> &block_of)
{
  std::vector<SchurComplement::Block> blocks(parts.size());
  for_each_part(parts.size(), parts_are_alike, [&](const unsigned int p) {
    blocks[p] = block_of(p);
  });
  complement = std::make_unique<SchurComplement>(std::move(blocks));
}



SchurComplement::Block
StaticCondensation::factorize(const LA::SparseMatrix &matrix,
                              const std::vector<unsigned int> &unknowns,
                              const double shift,
                              Part &part) const
{
  std::vector<unsigned int> first, last;
  std::set_difference(unknowns.begin(),
                      unknowns.end(),
                      cut.begin(),
                      cut.end(),
                      std::back_inserter(first));
  std::set_intersection(unknowns.begin(),
                        unknowns.end(),
                        cut.begin(),
                        cut.end(),
                        std::back_inserter(last));
  for (const unsigned int unknown : last)
    part.of_cut.push_back(std::lower_bound(cut.begin(), cut.end(), unknown) -
                          cut.begin());
  part.factor = std::make_unique<CholeskyFactor>(matrix, first, last, shift);
  return SchurComplement::square(part.of_cut, part.factor->last_block(), shift);
}



void
StaticCondensation::add_foundation(
  const std::vector<std::vector<std::pair<unsigned int, double>>> &springs)
{
  for (const auto &spring : springs)
    complement->add_square(spring);
}



const SchurComplement &
StaticCondensation::stiffness() const
{
  return *complement;
}



StaticCondensation::Eliminated
StaticCondensation::forward_eliminate(const LA::Vector &loads) const
{
  Eliminated result;
  result.of_parts.resize(parts.size());
  result.on_cut.resize(cut.size());
  for_each_part(parts.size(), is_large, [&](const unsigned int p) {
    auto &ordered = result.of_parts[p];
    ordered       = parts[p].factor->in_order(loads);
    parts[p].factor->forward_eliminate(ordered);
    const auto on_cut = ordered.end() - parts[p].of_cut.size();
    for (unsigned int i = 0; i < parts[p].of_cut.size(); ++i)
      result.on_cut[parts[p].of_cut[i]] = on_cut[i];
  });
  return result;
}



void
StaticCondensation::back_substitute(Eliminated loads,
                                    const std::vector<double> &of_cut,
                                    LA::Vector &x) const
{
  for_each_part(parts.size(), is_large, [&](const unsigned int p) {
    auto &ordered    = loads.of_parts[p];
    const auto &part = parts[p];
    const auto last  = ordered.end() - part.of_cut.size();
    for (unsigned int i = 0; i < part.of_cut.size(); ++i)
      last[i] = of_cut[part.of_cut[i]];
    part.factor->back_substitute(ordered);
    part.factor->from_order(ordered, x);
  });
}
} // namespace Setsudan
