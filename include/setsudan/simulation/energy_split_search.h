// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/simulation/split_search.h>

#include <memory>
#include <optional>
#include <vector>

namespace Setsudan
{
/**
 * Those rows split, one or several at once, that first set free what their new
 * area takes, at fixed travel and with the contact found anew: pushing on an
 * uncut surface is softer than pushing inside, so that a single row might never
 * do. Where the scene's forces press the blade in these follow the front, and
 * one row splits.
 */
template <int dim>
class EnergySplitSearch : public SplitSearch<dim>
{
public:
  using SplitSearch<dim>::SplitSearch;

  unsigned int
  n_looked_ahead(CutBody<dim> &body, const unsigned int row) const override;

  void
  begin(CutBody<dim> &body,
        CutContact<dim> &contact,
        const unsigned int row,
        const ContactPath<dim> &path,
        const BladeMotion &motion) override;

  double
  end() const override;

  void
  cross(const double travel) override;

  std::optional<Split>
  first_split(const BladeMotion &motion, const double end) override;

  CuttingStress
  stress_at(const double travel) const override;

  double
  surface_energy(CutBody<dim> &body,
                 const unsigned int row,
                 const unsigned int n,
                 const BladeMotion &motion,
                 const double released) const override;

private:
  /** Rows that may split together. */
  struct Trial
  {
    unsigned int n_rows;
    double area;
    /** The energy that a slow split takes. */
    double required;
    /** How far the front goes. */
    double length;
    /** The work of the scene's forces on that way, which follow the front. */
    double work;
    std::unique_ptr<ContactPath<dim>> path;
  };

  /** What it sets free over the travel. */
  Quadratic
  released(const Trial &trial) const;

  std::optional<double>
  travel_of_split(const Trial &trial,
                  const BladeMotion &motion,
                  const double end) const;

  /** The energy that a slow split of a row takes. */
  double
  required(CutBody<dim> &body, const unsigned int row) const;

  const ContactPath<dim> *before = nullptr;
  std::vector<Trial> trials;
};
} // namespace Setsudan
