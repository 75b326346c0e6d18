// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/cut_contact.h>

#include <memory>
#include <optional>

namespace Setsudan
{
/** Rows that split, all at once, and the travel of the blade at which they do.
 */
struct Split
{
  double travel;
  unsigned int n_rows;
  /** What drives and what is required there. */
  CuttingStress stress;
};

/**
 * Finds the travel of the blade at which rows split: one search for each front,
 * which goes along with the blade from one change of the contact to the next.
 * Of a blade that forces press in it finds the factor of these, which stands in
 * the place of the travel.
 */
template <int dim>
class SplitSearch
{
public:
  /** The search that the scene's criterion asks for.
   *
   * @param scene must live as long. */
  static std::unique_ptr<SplitSearch<dim>>
  make(const Scene<dim> &scene);

  explicit SplitSearch(const Scene<dim> &scene);

  virtual ~SplitSearch() = default;

  /** How many rows may split at once: one, unless a search says otherwise. */
  virtual unsigned int
  n_looked_ahead(CutBody<dim> &body, const unsigned int row) const;

  /** Begin at a front.
   *
   * @param path the contact while `row` rows are split; it must live as long
   *   as the search is at that front, as all others. */
  virtual void
  begin(CutBody<dim> &body,
        CutContact<dim> &contact,
        const unsigned int row,
        const ContactPath<dim> &path,
        const BladeMotion &motion) = 0;

  /** Up to which travel the contacts hold that are looked at besides the
   * path's; infinite where there are none. */
  virtual double
  end() const;

  /** Go on to those that hold beyond a travel. */
  virtual void
  cross(const double travel);

  /** The first split from where the blade is up to a travel, with the contacts
   * that hold now. */
  virtual std::optional<Split>
  first_split(const BladeMotion &motion, const double end) = 0;

  /** What drives the front row and what it requires at a travel at which the
   * contacts hold that are looked at. */
  virtual CuttingStress
  stress_at(const double travel) const = 0;

  /** The energy that new surface takes.
   *
   * @param row    the first of `n` rows that have split.
   * @param motion of the blade, before that is booked.
   * @param released what they set free besides friction. */
  virtual double
  surface_energy(CutBody<dim> &body,
                 const unsigned int row,
                 const unsigned int n,
                 const BladeMotion &motion,
                 const double released) const = 0;

  /** What the speed multiplies what is required with, if so much of the front
   * splits where the blade is. */
  double
  rate_factor(const double length,
              const BladeMotion &motion,
              const double travel) const;

protected:
  const Scene<dim> &scene;
};
} // namespace Setsudan
