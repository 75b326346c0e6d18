// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <setsudan/body/region.h>
#include <setsudan/cut/surface/cut_surface.h>
#include <setsudan/parameters/parameters.h>

#include <functional>
#include <string>
#include <vector>

namespace Setsudan
{
/** A surface of the mesh that a cut shall follow, and how well it does. */
template <int dim>
struct ChosenSurface
{
  CutSurface<dim> faces;
  /** Largest distance of the faces' nodes from the surface that was asked for,
   * in element sizes; 0 where the faces are that surface. */
  double roughness = 0;
  /** How much that distance differs from node to node, with its sign: 0 for
   * faces that run beside the surface, large for a cut in steps. */
  double unevenness = 0;
  /** How many faces of the surface are left out, because the body is open there
   * already. */
  unsigned int n_open = 0;
};

/** One item of `Cut/Surfaces`. */
template <int dim>
class SurfaceChoice
{
public:
  virtual ~SurfaceChoice() = default;

  /** @return no faces, where the surface lies outside of the body. */
  virtual ChosenSurface<dim>
  choose(const Body<dim> &body) const = 0;
};

/** `axis : boundary`: a boundary between layers of elements of a box, the
 * paper's dn (equations 19, 23, 26 of Kakefuda et al. 1996). */
template <int dim>
class LayerBoundary : public SurfaceChoice<dim>
{
public:
  LayerBoundary(const unsigned int axis, const unsigned int boundary);

  ChosenSurface<dim>
  choose(const Body<dim> &body) const override;

private:
  const unsigned int axis;
  const unsigned int boundary;
};

/**
 * `plane : point ; normal` and `where : expression`: the faces between the
 * cells whose centers lie on different sides of f(x) = 0, plus where f > 0.
 */
template <int dim>
class LevelSet : public SurfaceChoice<dim>
{
public:
  using Function = std::function<double(const dealii::Point<dim> &)>;

  /** @param function may return anything but a distance. */
  explicit LevelSet(const Function &function);

  ChosenSurface<dim>
  choose(const Body<dim> &body) const override;

private:
  /** The distance from the surface, with the function's sign.
   *
   * @param size of the element that the point belongs to. */
  double
  distance(const dealii::Point<dim> &point, const double size) const;

  /** The side of a cell: plus for those whose centers the surface passes
   * through, up to round-off, however the body lies in space. */
  int
  side(const CoarseMesh<dim> &mesh, const unsigned int cell) const;

  const Function function;
};

/** `group : name`: faces inside the body that the file has in a group. */
template <int dim>
class GroupOfFaces : public SurfaceChoice<dim>
{
public:
  explicit GroupOfFaces(const std::vector<EntityKey> &faces);

  /** Faces on the boundary of the body, which earlier cuts have opened, are
   * left out.
   *
   * @throw CutError where all are, or where the group is no surface
   * with two sides. */
  ChosenSurface<dim>
  choose(const Body<dim> &body) const override;

private:
  const std::vector<EntityKey> faces;
};

/** `between : A, B`: the faces between two groups of elements, plus in B. */
template <int dim>
class Interface : public SurfaceChoice<dim>
{
public:
  Interface(const std::vector<unsigned int> &minus,
            const std::vector<unsigned int> &plus);

  ChosenSurface<dim>
  choose(const Body<dim> &body) const override;

private:
  const std::vector<unsigned int> minus;
  const std::vector<unsigned int> plus;
};
} // namespace Setsudan
