// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/simulation/energy_split_search.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Setsudan
{
template <int dim>
unsigned int
EnergySplitSearch<dim>::n_looked_ahead(CutBody<dim> &body,
                                       const unsigned int row) const
{
  if (!this->scene.blade.travels)
    return 1;
  const unsigned int given = this->scene.division.look_ahead;
  const auto &rows         = body.seam().rows();
  if (given > 0 || row + 1 >= rows.size())
    return std::max(given, 1u);
  // A cut begins with about 3.7 times this length on any mesh.
  const double length = required(body, row) / body.area_of_row(row).area /
                        this->scene.material.smallest_youngs_modulus();
  const double row_length = rows[row + 1].depth - rows[row].depth;
  return std::max(2., std::ceil(4 * length / row_length));
}



template <int dim>
double
EnergySplitSearch<dim>::required(CutBody<dim> &body,
                                 const unsigned int row) const
{
  return requirement(body.area_of_row(row).energy, this->scene.blade.sharpness);
}



template <int dim>
void
EnergySplitSearch<dim>::begin(CutBody<dim> &body,
                              CutContact<dim> &contact,
                              const unsigned int row,
                              const ContactPath<dim> &path,
                              const BladeMotion &motion)
{
  before                    = &path;
  const unsigned int n_left = body.seam().rows().size() - row;
  const unsigned int most   = std::min(n_looked_ahead(body, row), n_left);
  trials.clear();
  double area = 0, energy = 0;
  const ContactPath<dim> *neighbour = before;
  for (unsigned int n = 1; n <= most; ++n)
    {
      area += body.area_of_row(row + n - 1).area;
      energy += required(body, row + n - 1);
      trials.push_back(
        {n,
         area,
         energy,
         body.length_of_rows(row, n),
         this->scene.blade.travels ? 0. : body.advance_of_blade(row).work,
         contact.path(row + n, 0, motion, neighbour)});
      neighbour = trials.back().path.get();
    }
}



template <int dim>
double
EnergySplitSearch<dim>::end() const
{
  double end = std::numeric_limits<double>::infinity();
  for (const auto &trial : trials)
    end = std::min(end, trial.path->end());
  return end;
}



template <int dim>
void
EnergySplitSearch<dim>::cross(const double travel)
{
  for (auto &trial : trials)
    if (trial.path->end() <= travel)
      trial.path->cross_end();
}



template <int dim>
Quadratic
EnergySplitSearch<dim>::released(const Trial &trial) const
{
  Quadratic energy = before->energy_set_free(*trial.path);
  energy.c[1] += trial.work;
  return energy;
}



template <int dim>
CuttingStress
EnergySplitSearch<dim>::stress_at(const double travel) const
{
  const Trial &trial = trials.front();
  // Behind the last nodes there may be nothing to open.
  if (trial.area == 0)
    return {0, 0};
  return {released(trial)(travel) / trial.area, trial.required / trial.area};
}



template <int dim>
std::optional<double>
EnergySplitSearch<dim>::travel_of_split(const Trial &trial,
                                        const BladeMotion &motion,
                                        const double end) const
{
  Quadratic gain = released(trial);
  if (!this->scene.rate.is_active())
    {
      gain.c[0] -= trial.required;
      return gain.first_root(motion.travel, end);
    }
  // What is required falls with the time since the last split, from infinity.
  const auto excess = [&](const double p) {
    return gain(p) /
             (trial.required * this->rate_factor(trial.length, motion, p)) -
           1;
  };
  if (excess(motion.travel) >= 0)
    return motion.travel;
  double last = std::min(end, motion.travel + trial.length);
  while (excess(last) < 0 && last < end)
    last = std::min(end, motion.travel + 2 * (last - motion.travel));
  if (!(excess(last) >= 0))
    return {};
  boost::uintmax_t most = 200;
  return boost::math::tools::toms748_solve(
           excess,
           motion.travel,
           last,
           boost::math::tools::eps_tolerance<double>(52),
           most)
    .second;
}



template <int dim>
std::optional<Split>
EnergySplitSearch<dim>::first_split(const BladeMotion &motion, const double end)
{
  const Trial *first = nullptr;
  double travel      = end;
  for (const auto &trial : trials)
    {
      const auto root = travel_of_split(trial, motion, travel);
      if (root && (!first || *root < travel))
        {
          first  = &trial;
          travel = *root;
        }
    }
  if (!first)
    return {};
  const double set_free = released(*first)(travel);
  const double taken =
    first->required * this->rate_factor(first->length, motion, travel);
  Split split{travel, first->n_rows, {}};
  // Behind the last nodes there may be nothing to open.
  if (first->area > 0)
    split.stress = {set_free / first->area, taken / first->area};
  return split;
}



template <int dim>
double
EnergySplitSearch<dim>::surface_energy(CutBody<dim> &body,
                                       const unsigned int row,
                                       const unsigned int n,
                                       const BladeMotion &motion,
                                       const double) const
{
  double energy = 0;
  for (unsigned int r = row; r < row + n; ++r)
    energy += required(body, r);
  return energy *
         this->rate_factor(body.length_of_rows(row, n), motion, motion.travel);
}



template class EnergySplitSearch<2>;
template class EnergySplitSearch<3>;
} // namespace Setsudan
