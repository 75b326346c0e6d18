// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/numbers.h>
#include <deal.II/base/symmetric_tensor.h>

#include <setsudan/body/transformation.h>
#include <setsudan/parameters/lists.h>

#include <cmath>

namespace Setsudan
{
using namespace dealii;

template <int dim>
void
Transformation<dim>::declare(ParameterHandler &handler)
{
  Setsudan::declare(handler,
                    "Body",
                    "Scale",
                    "1",
                    Patterns::List(Patterns::Double(), 1, dim),
                    "Factor by which the body is scaled about the origin, or "
                    "one factor for each axis, greater than 0 [-].");
  Setsudan::declare(handler,
                    "Body",
                    "Rotate",
                    "",
                    Patterns::Anything(),
                    dim == 3
                      ? "Rotations about axes through the origin, as 'axis : "
                        "angle', done in turn and separated by ';', such as "
                        "'z: 90; x: 45' [degrees]."
                      : "Rotation about the origin, as 'z : angle' [degrees].");
  Setsudan::declare(handler,
                    "Body",
                    "Translate",
                    dim == 3 ? "0, 0, 0" : "0, 0",
                    Patterns::List(Patterns::Double(), dim, dim),
                    "How far the body is moved, after scaling and rotation "
                    "[length].");
}



namespace
{
/** Cosine and sine, exact for right angles: a piece that is turned by 90
 * degrees lies as exactly as before. */
std::pair<double, double>
cos_and_sin(const double degrees)
{
  const double quarters = degrees / 90;
  if (quarters == std::round(quarters))
    {
      constexpr int cosine[] = {1, 0, -1, 0};
      const int quarter      = int(std::fmod(quarters, 4.) + 4) % 4;
      return {cosine[quarter], cosine[(quarter + 3) % 4]};
    }
  const double angle = degrees * numbers::PI / 180;
  return {std::cos(angle), std::sin(angle)};
}

template <int dim>
Tensor<2, dim>
rotation(const unsigned int axis, const double degrees)
{
  const unsigned int a = (axis + 1) % 3, b = (axis + 2) % 3;
  const auto [cosine, sine] = cos_and_sin(degrees);
  Tensor<2, dim> matrix(unit_symmetric_tensor<dim>());
  matrix[a][a] = matrix[b][b] = cosine;
  matrix[a][b]                = -sine;
  matrix[b][a]                = sine;
  return matrix;
}
} // namespace


template <int dim>
Transformation<dim>::Transformation(const Parameters &parameters)
  : matrix(unit_symmetric_tensor<dim>())
{
  const auto factors = parameters.numbers("Body", "Scale");
  parameters.require(factors.size() == 1 || factors.size() == dim,
                     "Body",
                     "Scale",
                     "one factor, or one for each axis");
  for (unsigned int d = 0; d < dim; ++d)
    {
      const double factor = factors[factors.size() == 1 ? 0 : d];
      parameters.require(factor > 0, "Body", "Scale", "factors greater than 0");
      matrix[d][d] = factor;
    }

  const std::string axes = dim == 3 ? "xyz" : "z";
  for (const auto &[axis, angle] :
       split_items(parameters.text("Body", "Rotate"), ';'))
    {
      std::vector<double> degrees;
      parameters.require(
        axis.size() == 1 && axes.find(axis) != std::string::npos &&
          parse_numbers(angle, degrees) && degrees.size() == 1,
        "Body",
        "Rotate",
        "'axis : angle' with an axis of " + axes + ", separated by ';'");
      matrix =
        rotation<dim>(std::string("xyz").find(axis), degrees[0]) * matrix;
    }

  const auto move = parameters.numbers("Body", "Translate", dim);
  for (unsigned int d = 0; d < dim; ++d)
    translation[d] = move[d];
}



template <int dim>
void
Transformation<dim>::apply(Body<dim> &body) const
{
  const auto moved = [&](const Point<dim> &point) {
    return Point<dim>(matrix * Tensor<1, dim>(point) + translation);
  };
  for (auto &vertex : body.mesh.vertices)
    vertex = moved(vertex);
  for (auto &of_cell : body.mesh.line_nodes)
    for (auto &node : of_cell)
      node = moved(node);
}



template struct Transformation<2>;
template struct Transformation<3>;
} // namespace Setsudan
