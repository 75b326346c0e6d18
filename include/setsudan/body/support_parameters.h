// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/tensor.h>

#include <setsudan/body/body.h>
#include <setsudan/body/region.h>
#include <setsudan/parameters/parameters.h>

#include <bitset>
#include <string>
#include <vector>

namespace Setsudan
{
/** A region of which some displacement components are prescribed. */
template <int dim>
struct Support
{
  Region<dim> region;
  std::bitset<dim> components;
  /** The displacement of the held components. */
  dealii::Tensor<1, dim> displacement;
  /** As the scene has it. */
  std::string text = {};
};

/** Subsection `Support`: what holds the body, or moves it. */
template <int dim>
struct SupportParameters
{
  /** What becomes of a piece that no support holds. */
  enum class LoosePieces
  {
    hold,
    drop
  };

  std::vector<Support<dim>> supports;
  LoosePieces floating_pieces;

  static void
  declare(dealii::ParameterHandler &handler);

  /** @throw SceneError for a group or node that does not exist. */
  SupportParameters(const Parameters &parameters, const Body<dim> &body);

private:
  void
  read_groups(const Parameters &parameters, const Body<dim> &body);

  void
  read_boxes(const Parameters &parameters, const Body<dim> &body);

  void
  read_displacements(const Parameters &parameters, const Body<dim> &body);
};
} // namespace Setsudan
