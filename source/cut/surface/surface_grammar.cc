// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <setsudan/body/group_of_word.h>
#include <setsudan/cut/surface/expression.h>
#include <setsudan/cut/surface/surface_grammar.h>
#include <setsudan/parameters/lists.h>

#include <cmath>

namespace Setsudan
{
using namespace dealii;

namespace
{
[[noreturn]] void
reject(const Parameters &parameters, const std::string &allowed)
{
  parameters.reject("Cut", "Surfaces", allowed);
}

template <int dim>
std::shared_ptr<SurfaceChoice<dim>>
read_layer_boundary(const Parameters &parameters,
                    const Body<dim> &body,
                    const std::string &axis,
                    const std::string &text)
{
  if (!body.box)
    reject(parameters,
           "for a body from a file a plane, group, between or where, since it "
           "has no numbered layers of elements");
  const unsigned int d = std::string("xyz").find(axis);
  const unsigned int n = body.box->n_elements[d];
  std::vector<double> number;
  if (!(parse_numbers(text, number) && number.size() == 1 && number[0] >= 1 &&
        number[0] <= n - 1. &&
        number[0] == static_cast<unsigned int>(number[0])))
    reject(parameters,
           n == 1
             ? "no cut across " + axis + ", where the body is one element thick"
             : "for " + axis + " a boundary from 1 to " +
                 std::to_string(n - 1));
  return std::make_shared<LayerBoundary<dim>>(
    d, static_cast<unsigned int>(number[0]));
}



template <int dim>
std::shared_ptr<SurfaceChoice<dim>>
read_plane(const Parameters &parameters,
           const std::string &point_text,
           const std::string &normal_text)
{
  std::vector<double> values, components;
  const bool valid = parse_numbers(point_text, values) &&
                     parse_numbers(normal_text, components) &&
                     values.size() == dim && components.size() == dim;
  Point<dim> point;
  Tensor<1, dim> normal;
  for (unsigned int d = 0; valid && d < dim; ++d)
    {
      point[d]  = values[d];
      normal[d] = components[d];
    }
  if (!valid || normal.norm() == 0)
    reject(parameters,
           dim == 3 ? "'plane : px, py, pz ; nx, ny, nz', a point and a normal "
                      "that is not zero"
                    : "'plane : px, py ; nx, ny', a point and a normal that is "
                      "not zero");
  normal /= normal.norm();
  return std::make_shared<LevelSet<dim>>(
    [=](const Point<dim> &x) { return normal * (x - point); });
}



/** What is wrong with the values of an expression at the body's corners. */
template <int dim>
std::string
problem_in_body(const Expression<dim> &expression, const Body<dim> &body)
{
  bool is_comparison = true;
  for (const auto &vertex : body.mesh.vertices)
    {
      const double value = expression(vertex);
      if (!std::isfinite(value))
        return "no number somewhere in the body";
      is_comparison = is_comparison && (value == 0 || value == 1);
    }
  if (is_comparison && expression.compares())
    return "it compares; write f(" + std::string(dim == 3 ? "x,y,z" : "x,y") +
           ") that is 0 on the cut, such as 'y - 2' for 'y == 2'";
  return "";
}

template <int dim>
std::shared_ptr<SurfaceChoice<dim>>
read_expression(const Parameters &parameters,
                const Body<dim> &body,
                const std::string &text)
{
  const std::string variables = dim == 3 ? "x,y,z" : "x,y";
  const Expression<dim> expression(variables, text);
  std::string problem = expression.problem();
  if (problem.empty())
    problem = problem_in_body(expression, body);
  if (!problem.empty())
    reject(parameters,
           "'where : expression' in " + variables +
             " that muParser understands; '" + text + "' is none: " + problem);
  return std::make_shared<LevelSet<dim>>(expression);
}



template <int dim>
std::shared_ptr<SurfaceChoice<dim>>
read_group(const Parameters &parameters,
           const Body<dim> &body,
           const std::string &word)
{
  return std::make_shared<GroupOfFaces<dim>>(
    find_group_or_reject(
      parameters, "Cut", "Surfaces", body, word, GroupKind::faces)
      .entities);
}



template <int dim>
std::shared_ptr<SurfaceChoice<dim>>
read_interface(const Parameters &parameters,
               const Body<dim> &body,
               const std::string &text)
{
  const auto words = split(text, ',');
  if (words.size() != 2)
    reject(parameters, "'between : A, B' with two groups of elements");
  const auto elements = [&](const std::string &word) {
    return find_group_or_reject(
             parameters, "Cut", "Surfaces", body, word, GroupKind::elements)
      .cells;
  };
  return std::make_shared<Interface<dim>>(elements(words[0]),
                                          elements(words[1]));
}
} // namespace


template <int dim>
std::vector<SurfaceItem<dim>>
read_surfaces(const Parameters &parameters, const Body<dim> &body)
{
  const auto parts = split(parameters.text("Cut", "Surfaces"), ';');
  std::vector<SurfaceItem<dim>> items;
  for (unsigned int i = 0; i < parts.size(); ++i)
    {
      const auto [kind, text] = split_items(parts[i], ';').front();
      const std::string axes  = std::string("xyz").substr(0, dim);
      if (kind.size() == 1 && axes.find(kind) != std::string::npos)
        items.push_back({kind + ":" + text,
                         read_layer_boundary(parameters, body, kind, text)});
      else if (kind == "plane")
        {
          // The normal stands behind a ';' of its own.
          const std::string normal = i + 1 < parts.size() ? parts[++i] : "";
          items.push_back({"plane: " + text + "; " + normal,
                           read_plane<dim>(parameters, text, normal)});
        }
      else if (kind == "where")
        items.push_back(
          {"where: " + text, read_expression(parameters, body, text)});
      else if (kind == "group")
        items.push_back({"group: " + text, read_group(parameters, body, text)});
      else if (kind == "between")
        items.push_back(
          {"between: " + text, read_interface(parameters, body, text)});
      else
        reject(parameters,
               "'axis : boundary' with an axis of " + axes +
                 ", 'plane : point ; normal', 'group : name', 'between : A, "
                 "B' or 'where : expression', separated by ';'");
    }
  return items;
}



template <int dim>
std::vector<Extent<dim>>
read_extents(const Parameters &parameters, const unsigned int n_surfaces)
{
  using Vector = Tensor<1, dim>;
  std::vector<Extent<dim>> extents;
  for (const auto &[kind, text] :
       split_items(parameters.text("Cut", "Extent"), ';'))
    {
      std::vector<double> values;
      const bool numbers = parse_numbers(text, values);
      if (kind == "all" && text.empty())
        extents.push_back(
          [](const Point<dim> &, const double, const Vector &, const double) {
            return true;
          });
      else if (kind == "depth" && numbers && values.size() == 1 &&
               values[0] > 0)
        extents.push_back([depth = values[0]](const Point<dim> &center,
                                              const double tolerance,
                                              const Vector &direction,
                                              const double entry) {
          return direction * Vector(center) - entry <= depth + tolerance;
        });
      else if (kind == "box" && numbers && values.size() == 2 * dim)
        extents.push_back([values](const Point<dim> &center,
                                   const double tolerance,
                                   const Vector &,
                                   const double) {
          bool inside = true;
          for (unsigned int d = 0; d < dim; ++d)
            inside = inside && center[d] >= values[d] - tolerance &&
                     center[d] <= values[dim + d] + tolerance;
          return inside;
        });
      else
        parameters.reject("Cut",
                          "Extent",
                          "'all', 'depth : d' with d greater than 0, or 'box "
                          ": smallest, then largest coordinates', separated "
                          "by ';'");
    }
  parameters.require(extents.size() == 1 || extents.size() == n_surfaces,
                     "Cut",
                     "Extent",
                     "one item for all surfaces, or one for each");
  return extents;
}



template std::vector<SurfaceItem<2>>
read_surfaces(const Parameters &, const Body<2> &);
template std::vector<SurfaceItem<3>>
read_surfaces(const Parameters &, const Body<3> &);
template std::vector<Extent<2>>
read_extents(const Parameters &, const unsigned int);
template std::vector<Extent<3>>
read_extents(const Parameters &, const unsigned int);
} // namespace Setsudan
