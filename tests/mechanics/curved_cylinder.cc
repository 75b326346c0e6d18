// SPDX-License-Identifier: LGPL-2.1-or-later
// Curved elements of gmsh against closed forms. A round cylinder in torsion
// (Saint-Venant, whose sections turn as a whole): the elements contain it. A
// tube under inner pressure (Lamé), in 2D and in 3D: the displacement converges
// with the third order where the file's middle nodes are kept, and with the
// second where its sides are taken for straight. doc/bodies.md has the table.

#include <setsudan/body/gmsh/gmsh_file.h>

#include <cmath>
#include <fstream>
#include <functional>

#include "../test_setup.h"
#include "exact_problem.h"

using namespace Setsudan;
using namespace dealii;

const double radius = 2., height = 4., twist = 0.1;
const double inner = 1., outer = 2., pressure = 0.3;
const double E = 5., nu = 0.3;

template <int dim>
using Field = std::function<Tensor<1, dim>(const Point<dim> &)>;


/** A solid cylinder: a square core and four blocks around it. */
std::string
cylinder(const unsigned int n)
{
  return "r = " + std::to_string(radius) + "; n = " + std::to_string(n) +
         "; h = " + std::to_string(height) + R"(;
Mesh.ElementOrder = 2; Mesh.SecondOrderIncomplete = 1;
Point(1) = {0, 0, 0}; q = r / 2;
Point(2) = {-q/Sqrt(2), -q/Sqrt(2), 0}; Point(3) = {q/Sqrt(2), -q/Sqrt(2), 0};
Point(4) = {q/Sqrt(2), q/Sqrt(2), 0};   Point(5) = {-q/Sqrt(2), q/Sqrt(2), 0};
Point(6) = {-r/Sqrt(2), -r/Sqrt(2), 0}; Point(7) = {r/Sqrt(2), -r/Sqrt(2), 0};
Point(8) = {r/Sqrt(2), r/Sqrt(2), 0};   Point(9) = {-r/Sqrt(2), r/Sqrt(2), 0};
For i In {0:3}
  j = (i + 1) % 4;
  Line(1 + i) = {2 + i, 2 + j}; Circle(5 + i) = {6 + i, 1, 6 + j};
  Line(9 + i) = {2 + i, 6 + i};
EndFor
Curve Loop(1) = {1:4}; Plane Surface(1) = {1};
For i In {0:3}
  j = (i + 1) % 4;
  Curve Loop(2 + i) = {9 + i, 5 + i, -(9 + j), -(1 + i)};
  Plane Surface(2 + i) = {2 + i};
EndFor
Transfinite Curve{1:12} = n + 1; Transfinite Surface{1:5};
Recombine Surface{1:5};
Extrude {0, 0, h} { Surface{1:5}; Layers{n}; Recombine; }
)";
}


/** A quarter of a ring, in 3D of a tube; its straight sides glide. */
template <int dim>
std::string
ring(const unsigned int n)
{
  return "n = " + std::to_string(n) + "; a = " + std::to_string(inner) +
         "; b = " + std::to_string(outer) + R"(;
Mesh.ElementOrder = 2; Mesh.SecondOrderIncomplete = 1;
Point(1) = {0, 0, 0}; Point(2) = {a, 0, 0}; Point(3) = {b, 0, 0};
Point(4) = {0, b, 0}; Point(5) = {0, a, 0};
Line(1) = {2, 3}; Circle(2) = {3, 1, 4}; Line(3) = {4, 5};
Circle(4) = {5, 1, 2};
Curve Loop(1) = {1:4}; Plane Surface(1) = {1};
Transfinite Curve{1:4} = n + 1; Transfinite Surface{1};
Recombine Surface{1};
)" +
         (dim == 2
            ?
            R"(Physical Curve("inner") = {4}; Physical Curve("x axis") = {1};
Physical Curve("y axis") = {3};
)"
            :
            R"(e[] = Extrude {0, 0, 1} { Surface{1}; Layers{1}; Recombine; };
Physical Surface("x axis") = {e[2]}; Physical Surface("y axis") = {e[4]};
Physical Surface("inner") = {e[5]}; Physical Surface("ends") = {1, e[0]};
Physical Volume("tube") = {e[1]};
)");
}


template <int dim>
Body<dim>
read(const std::string &geometry, const bool curved)
{
  std::ofstream("body.geo") << geometry;
  Body<dim> body = read_gmsh_file<dim>("body.geo");
  if (!curved)
    body.mesh.line_nodes.clear();
  return body;
}


/** The error of the displacement in the L2 norm. */
template <int dim>
double
error(const Body<dim> &body,
      Assignments assignments,
      const Field<dim> &exact,
      const std::function<bool(const Point<dim> &)> &holds)
{
  assignments.push_back("Material/Young's modulus=" + std::to_string(E));
  assignments.push_back("Material/Poisson's ratio=" + std::to_string(nu));
  return ExactProblem<dim>(body, assignments)
    .errors({exact, {}}, holds)
    .displacement;
}


double
torsion_error(const unsigned int n)
{
  return error<3>(
    read<3>(cylinder(n), true),
    {},
    [](const Point<3> &p) {
      return Tensor<1, 3>({-twist * p[2] * p[1], twist * p[2] * p[0], 0.});
    },
    [](const Point<3> &p) {
      return std::abs(p[2]) < 1e-9 || std::abs(p[2] - height) < 1e-9;
    });
}


template <int dim>
double
pressure_error(const unsigned int n, const bool curved)
{
  // Lamé, plane strain: u_r = (1 + nu)/E p a^2/(b^2 - a^2)
  //                           ((1 - 2 nu) r + b^2/r).
  const double factor =
    (1 + nu) / E * pressure * inner * inner / (outer * outer - inner * inner);
  return error<dim>(
    read<dim>(ring<dim>(n), curved),
    {"Load/Pressures=inner : " + std::to_string(pressure),
     std::string("Support/Fixed components=x axis : y; y axis : x") +
       (dim == 3 ? "; ends : z" : "")},
    [&](const Point<dim> &p) {
      Tensor<1, dim> u;
      u[0] = p[0];
      u[1] = p[1];
      return factor * (1 - 2 * nu + outer * outer / u.norm_square()) * u;
    },
    [](const Point<dim> &) { return false; });
}


template <int dim>
void
print_table(const std::vector<unsigned int> &sizes)
{
  std::cout << (dim == 2 ? "ring" : "tube") << " under pressure" << std::endl;
  std::vector<double> last(2);
  std::cout << std::setprecision(3);
  for (const unsigned int n : sizes)
    {
      std::cout << "n = " << n;
      for (const bool curved : {true, false})
        {
          const double e = pressure_error<dim>(n, curved);
          std::cout << (curved ? "  curved " : "  straight ") << e;
          if (last[curved] > 0)
            std::cout << " order " << std::log2(last[curved] / e);
          last[curved] = e;
        }
      std::cout << std::endl;
    }
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    for (const unsigned int n : {1, 2, 3})
      check_below("torsion, n = " + std::to_string(n), torsion_error(n), 1e-9);
    print_table<2>({2, 4, 8, 16});
    print_table<3>({2, 4, 8});
  });
}
