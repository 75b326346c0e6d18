// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid motions, and the fewest components that hold a body against those which
// its fixed points leave free.

#include <setsudan/space/rigid_modes.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

template <int dim>
using Points = std::vector<Point<dim>>;

template <int dim>
using HeldPoints = std::vector<HeldPoint<dim>>;

/** Points that are held in all directions. */
template <int dim>
HeldPoints<dim>
fix(const Points<dim> &points)
{
  HeldPoints<dim> held;
  for (const auto &point : points)
    held.push_back({point, std::bitset<dim>().set()});
  return held;
}

/** The corners of a box from `origin` to `origin + size`. */
template <int dim>
Points<dim>
corners(const Point<dim> &size, const Point<dim> &origin = Point<dim>())
{
  Points<dim> points;
  for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_cell; ++v)
    {
      points.push_back(origin);
      for (unsigned int d = 0; d < dim; ++d)
        points.back()[d] += size[d] * GeometryInfo<dim>::unit_cell_vertex(v)[d];
    }
  return points;
}


/** No distance changes: (u(p) - u(q)) . (p - q) = 0. */
template <int dim>
void
test_modes()
{
  Point<dim> size;
  for (unsigned int d = 0; d < dim; ++d)
    size[d] = d + 1;
  const auto points = corners(size);
  double stretch    = 0;
  for (const auto &p : points)
    for (const auto &q : points)
      for (unsigned int m = 0; m < n_rigid_modes<dim>; ++m)
        stretch = std::max(stretch,
                           std::abs((rigid_modes(p, points[1], 2.)[m] -
                                     rigid_modes(q, points[1], 2.)[m]) *
                                    (p - q)));
  check_below("stretch in rigid motions", stretch, 1e-14);
}


/** The smallest singular value of what the hold and the held points stop,
 * in motions that are scaled with the body: 0 if a motion is left. */
template <int dim>
double
firmness(const HeldPoints<dim> &fixed,
         const Points<dim> &candidates,
         const std::vector<PointComponent> &hold)
{
  std::vector<std::pair<Point<dim>, unsigned int>> held;
  for (const auto &[point, component] : hold)
    held.emplace_back(candidates[point], component);
  for (const auto &point : fixed)
    for (unsigned int c = 0; c < dim; ++c)
      if (point.components[c])
        held.emplace_back(point.position, c);

  const Tensor<1, dim> diagonal = candidates.back() - candidates.front();
  const Point<dim> center       = candidates.front() + diagonal / 2;
  LAPACKFullMatrix<double> matrix(held.size(), n_rigid_modes<dim>);
  for (unsigned int i = 0; i < held.size(); ++i)
    for (unsigned int m = 0; m < n_rigid_modes<dim>; ++m)
      matrix(i, m) = rigid_modes(
        held[i].first, center, diagonal.norm() / 2)[m][held[i].second];
  if (held.size() < n_rigid_modes<dim>)
    return 0;
  matrix.compute_svd();
  return matrix.singular_value(n_rigid_modes<dim> - 1);
}


template <int dim>
void
test_hold(const std::string &name,
          const Points<dim> &candidates,
          const HeldPoints<dim> &fixed)
{
  const auto hold = find_minimal_hold(fixed, candidates);
  std::cout << dim << "D, " << name << ": " << hold.size() << " to hold, "
            << (firmness(fixed, candidates, hold) > 1e-3 ? "firm"
                                                         : "FAILED, loose")
            << std::endl;
}


void
test_space(const std::string &name, const Points<3> &c)
{
  std::cout << name << std::endl;
  test_hold<3>("free", c, {});
  const auto fix = [](const Points<3> &points) { return ::fix<3>(points); };
  test_hold<3>("one fixed point", c, fix({c[3]}));
  test_hold<3>("the same point twice", c, fix({c[3], c[3]}));
  test_hold<3>("two fixed points", c, fix({c[0], c[1]}));
  test_hold<3>(
    "three on a line", c, fix({c[0], c[1], c[0] + (c[1] - c[0]) / 2}));
  test_hold<3>("three fixed points", c, fix({c[0], c[1], c[2]}));
  test_hold<3>("a fixed face", c, fix({c[0], c[1], c[2], c[3]}));
  test_hold<3>("a fixed body", c, fix(c));
  // Some components only, as bits: x is 1, y is 2, z is 4.
  test_hold<3>("a point in x", c, {{c[3], 1}});
  test_hold<3>("a board under it", c, {{c[0], 4}, {c[1], 4}, {c[2], 4}});
  test_hold<3>("a board, one point too many",
               c,
               {{c[0], 4}, {c[1], 4}, {c[2], 4}, {c[3], 4}});
  test_hold<3>("three planes", c, {{c[0], 7}, {c[1], 6}, {c[2], 4}, {c[3], 4}});
}


void
test_plane(const std::string &name, const Points<2> &c)
{
  std::cout << name << std::endl;
  test_hold<2>("free", c, {});
  test_hold<2>("one fixed point", c, fix<2>({c[2]}));
  test_hold<2>("two fixed points", c, fix<2>({c[0], c[3]}));
  test_hold<2>("a fixed side", c, fix<2>({c[0], c[1]}));
  test_hold<2>("a point in x", c, {{c[2], 1}});
  test_hold<2>("a side in y", c, {{c[0], 2}, {c[1], 2}});
  test_hold<2>("two sides", c, {{c[0], 3}, {c[1], 2}});
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_modes<2>();
    test_modes<3>();
    test_space("cube", corners(Point<3>(1, 1, 1)));
    test_space("far cube",
               corners(Point<3>(1, 1, 1), Point<3>(1e4, -1e4, 1e4)));
    test_space("small cube", corners(Point<3>(1e-9, 1e-9, 1e-9)));
    test_space("bar", corners(Point<3>(50, 2, 2)));
    test_plane("square", corners(Point<2>(1, 1)));
    test_plane("far strip", corners(Point<2>(50, 2), Point<2>(1e4, 1e4)));
  });
}
