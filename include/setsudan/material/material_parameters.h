// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/body.h>
#include <setsudan/material/cut_limit.h>
#include <setsudan/material/law_parameters.h>
#include <setsudan/parameters/parameters.h>

#include <memory>
#include <string>
#include <vector>

namespace Setsudan
{
/** What a part of the body is made of. */
struct Material
{
  /** How it answers to small strains; of an orthotropic material the isotropic
   * mean, for scales only. */
  Hooke at_rest;
  std::shared_ptr<const ConstitutiveLaw> law;
  /** [force/area] */
  CutLimit shear_limit;
  /** Energy per new area that a blade of sharpness 0 needs [force/length]. */
  CutLimit toughness;
  /** Whether the change of volume is projected (see Dilatation). */
  bool is_mixed;
};

/** Subsection `Material`: the materials, and which element has which. */
template <int dim>
class MaterialParameters
{
public:
  static void
  declare(dealii::ParameterHandler &handler);

  /** @throw SceneError for a value that no material has, or a group of
   * elements that the body does not have. */
  MaterialParameters(const Parameters &parameters, const Body<dim> &body);

  const Material &
  of_element(const unsigned int element) const;

  /** Number of the element's material, from 0. */
  unsigned int
  number(const unsigned int element) const;

  unsigned int
  n_materials() const;

  const std::vector<Material> &
  all() const
  {
    return materials;
  }

  /**
   * Add the work that a blunt edge takes, per area that it divides: over its
   * width the material yields, in tension at twice its shear limit.
   *
   * @param width of the edge, times 1 and Coulomb's coefficient of the
   *   material's slip around it. */
  void
  add_work_of_edge(const double width);

  /** The smallest shear limit of all. */
  double
  smallest_shear_limit() const;

  /** The smallest toughness of all. */
  double
  smallest_toughness() const;

  /** The smallest Young's modulus of all, at rest. */
  double
  smallest_youngs_modulus() const;

  /** Whether some of the materials need the mixed formulation. */
  bool
  any_is_mixed() const;

  /** Whether the laws of all are linear. */
  bool
  is_linear() const;

  /** Whether the laws of all are linear and isotropic, as the kernels without a
   * matrix need it. */
  bool
  is_hookean() const;

  /** Whether any stays deformed beyond a limit. */
  bool
  is_plastic() const;

  /** Whether the stress of any depends on time. */
  bool
  is_viscous() const;

  /** Whether the law of any has internal variables. */
  bool
  has_internal_variables() const;

  /** Let a material have another law, with the same moduli at rest. */
  void
  set_law(const unsigned int number,
          const std::shared_ptr<const ConstitutiveLaw> &law);

  /** Let laws be those of finite strain from now on. Strain must be
   * `automatic`. */
  void
  take_finite_strain();

  double linear_range;
  /** What the scene asks for. */
  LawParameters::Strain strain;
  /** Whether laws are those of finite strain now. */
  bool finite_strain;
  /** Whether the scene names the formulation, rather than leave it to
   * Poisson's ratio. */
  bool formulation_is_named;

private:
  std::vector<Material> materials;
  /** Of finite strain, where strain is small so far. */
  std::vector<std::shared_ptr<const ConstitutiveLaw>> laws_to_come;
  /** Empty where there is one material only. */
  std::vector<unsigned int> material_of_element;
};
} // namespace Setsudan
