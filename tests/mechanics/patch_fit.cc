// SPDX-License-Identifier: LGPL-2.1-or-later
// A polynomial is found again from its values at scattered points;
// from points in two layers without its square across them; and from points on
// a line as far as they tell.

#include <setsudan/mechanics/stress/patch_fit.h>

#include <cmath>
#include <functional>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

template <int dim>
std::vector<Point<dim>>
grid(const std::array<unsigned int, dim> &n)
{
  std::vector<Point<dim>> points(1);
  for (unsigned int d = 0; d < dim; ++d)
    {
      std::vector<Point<dim>> more;
      for (const auto &point : points)
        for (unsigned int i = 0; i < n[d]; ++i)
          {
            more.push_back(point);
            more.back()[d] = 7 + 0.3 * i + 0.02 * i * i;
          }
      points = more;
    }
  return points;
}


template <int dim>
void
test(const std::string &name,
     const std::vector<Point<dim>> &points,
     const std::function<double(const Point<dim> &)> &function)
{
  const PatchFit<dim> fit(points, points[points.size() / 2], 1.);
  double error = 0;
  for (auto point : points)
    {
      // Not one of the points themselves.
      point[0] += 0.1;
      const auto weights = fit.weights_at(point);
      double value       = 0;
      for (unsigned int s = 0; s < points.size(); ++s)
        value += weights[s] * function(points[s]);
      error = std::max(error, std::abs(value - function(point)));
    }
  std::cout << name << ", " << fit.n_functions() << " functions" << std::endl;
  check_below("  error", error, 1e-8);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test<2>("2D", grid<2>({{4, 4}}), [](const Point<2> &p) {
      return 1 + p[0] - 2 * p[1] + p[0] * p[1] - 3 * p[1] * p[1];
    });
    test<3>("3D", grid<3>({{4, 3, 3}}), [](const Point<3> &p) {
      return 2 - p[2] + p[0] * p[2] - p[1] * p[1] + 4 * p[2] * p[2];
    });
    test<3>("two layers", grid<3>({{4, 4, 2}}), [](const Point<3> &p) {
      return 2 - p[2] + p[0] * p[2] - p[1] * p[1];
    });
    test<2>("a line", grid<2>({{4, 1}}), [](const Point<2> &p) {
      return 1 + p[0] - p[0] * p[0];
    });
  });
}
